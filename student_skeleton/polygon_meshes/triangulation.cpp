#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE triangulation: cut every face with more than three corners into triangles.
//
//      p4 ---- p3              p4 ---- p3
//      |         `.            |     .' .`.
//      |    f      p2          |   .' .'   p2         n corners: n - 2 triangles,
//      |         .'            | .' .'   .'           n - 3 new edges
//      p0 ---- p1              p0 ---- p1
//
// Any pattern is right. Vertices, old edges and boundary loops stay as they are.
void PolyMesh::triangulate() {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::triangulate");
}

}  // namespace meshedit
