#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE isotropic_remeshing: make the triangles of a mesh alike.
//
//      x ------- x             x ------- x
//      | `-.  .-'|             | \     / |          1. split what is too long
//      |   .xx   |             |  \   /  |          2. collapse what is too short
//      | .'   `-.|             |    x    |          3. flip towards six edges at each vertex
//      x ------- x             x ------- x          4. smooth along the surface
//
// In each round L is the mean length of the edges: too long is what exceeds longerFactor L,
// too short what is below shorterFactor L. An edge is flipped if that lowers the sum of |n - 6|
// over the four vertices of its two triangles, n being the number of edges at a vertex.
//
// To smooth, each vertex p goes to p + step (u - (u . N) N): u leads to the mean of its
// neighbours, N is its unit normal, weighted by areas. All of them from the positions before.
//
// Splits add to the list of edges that you walk over, collapses take from it: which edges are
// gone after one? Call your own splitEdge, collapseEdge and flipEdge; a collapse or a flip may
// be refused.
void PolyMesh::isotropicRemesh(const RemeshParameters& parameters) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::isotropicRemesh");
}

}  // namespace meshedit
