#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_split_polygon: put a new vertex in the middle of an edge, and cut the faces on
// its sides.
//
//      d ---- a ---- y        d ---- a ---- y
//      |      |      |        |   `- |      |
//      |      |      |        |      m      |         new: m, its edges to b, c and d
//      |      |      |        |      | `-.  |
//      x ---- b ---- c        x ---- b ---- c
//
// In each face a new edge runs from m to the corner that FOLLOWS the edge there: c follows b,
// and on the other side d follows a. Faces may have any number of corners. Outside of the
// surface nothing is cut: at the boundary there is one new edge less, and one new face.
//
// Return m. Its halfedge() must lie along the old edge.
std::optional<VertexIter> PolyMesh::splitEdge(EdgeIter e) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::splitEdge");
}

}  // namespace meshedit
