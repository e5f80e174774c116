#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE vertex_inset: put a new vertex into a face and join it to every corner.
//
//      o ---------- o        o ---------- o
//      |            |        | `.      .' |
//      |            |        |   `.  .'   |
//      |     f      |        |      m     |           n corners: n triangles
//      |            |        |   .'  `.   |
//      |            |        | .'      `. |
//      o ---------- o        o ---------- o
//
// m lies at the mean of the corners. One of the triangles may keep the old face; the sides of
// the old face are one side of a triangle each. Return m.
std::optional<VertexIter> PolyMesh::insetVertex(FaceIter f) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::insetVertex");
}

}  // namespace meshedit
