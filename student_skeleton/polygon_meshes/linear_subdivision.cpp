#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE linear_subdivision: where the vertices of the next level lie, without smoothing.
//
//      o ------ o           v -- e -- v
//      |        |           |    |    |         v  an old vertex: it stays
//      |        |    ->     e -- f -- e         e  the middle of an edge
//      |        |           |    |    |         f  the mean of the corners of a face
//      o ------ o           v -- e -- v
//
// Compute the positions only: the mesh stays as it is, and is cut elsewhere. Every vertex, edge
// and face has one; boundary loops have none.
RefinedPositions PolyMesh::linearPositions() {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::linearPositions");
}

}  // namespace meshedit
