#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE catmull_clark: where the vertices of the next level lie, by Catmull and Clark.
//
//   face f         the mean of its corners
//
//   edge a-b       (a + b + f + g) / 4, with the new vertices f, g of the faces beside it
//                  on a boundary: (a + b) / 2
//
//   vertex S       (Q + 2 R + (n - 3) S) / n      n edges
//                  Q  the mean of the new vertices of the faces around
//                  R  the mean of the middles of the edges at it (NOT of their new vertices)
//                  on a boundary: 3/4 S + 1/8 (a + b), a and b along the boundary
//
// Compute the positions only: the mesh stays as it is, and is cut elsewhere. Every vertex, edge
// and face has one; boundary loops have none.
RefinedPositions PolyMesh::catmullClarkPositions() {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::catmullClarkPositions");
}

}  // namespace meshedit
