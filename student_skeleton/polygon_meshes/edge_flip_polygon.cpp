#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE edge_flip_polygon: turn an edge by one corner, counter-clockwise in both faces.
//
//      d ---- a ---- y        d ---- a ---- y
//      |      |      |        | `-.      f  |
//      |  g   |   f  |        |    `-.      |         before: a - b      after: d - c
//      |      |      |        |  g    `-.   |
//      x ---- b ---- c        x ---- b --`- c
//
// Nothing is created and nothing is deleted. The half-edges b-c and a-d change their face; the
// two half-edges of the edge move; the half-edges before them get another next. Which pointers
// of vertices and faces may lead somewhere wrong afterwards?
//
// Return std::nullopt, and change nothing, for a boundary edge, and where c lies in g or d in
// f: that face would visit a vertex twice.
std::optional<EdgeIter> PolyMesh::flipEdge(EdgeIter e) {
  // TODO: your code goes here. Delete the next line when you start.
  notImplemented("PolyMesh::flipEdge");
}

}  // namespace meshedit
