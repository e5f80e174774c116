#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE vertex_dissolve: take a vertex away; the faces around it become one.
//
//      o ---- o ---- o        o ---- o ---- o
//      |      |      |        |             |
//      o ---- v ---- o        o      f      o         on a boundary: a new edge joins the two
//      |      |      |        |             |         neighbours of v there
//      o ---- o ---- o        o ---- o ---- o
//
// All edges at v go. On a boundary, what is left of the faces is closed by ONE new edge, and
// the boundary loop takes its other side.
//
// Look first, and return std::nullopt without a change, if no surface would be left: the new
// face would have fewer than three corners or visit one of them twice, or a boundary of three
// edges would lose one.
std::optional<FaceIter> PolyMesh::dissolveVertex(VertexIter v) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::dissolveVertex");
}

}  // namespace meshedit
