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
  // SOLUTION BEGIN PolyMesh::triangulate
  std::vector<FaceIter> old_faces;  // new ones join the list while we cut
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f)
    old_faces.push_back(f);
  for (FaceIter f : old_faces) {
    std::vector<HalfedgeIter> sides;
    HalfedgeIter h = f->halfedge();
    do {
      sides.push_back(h);
      h = h->next();
    } while (h != f->halfedge());

    // All triangles meet at the corner where side 0 starts. The last one keeps f.
    const Size n = sides.size();
    HalfedgeIter leaving = sides[0];  // from that corner, in the triangle that comes next
    for (Size i = 1; i + 2 < n; ++i) {
      const FaceIter triangle = newFace();
      const EdgeIter cut = newEdge();
      const HalfedgeIter back = newHalfedge();
      const HalfedgeIter forth = newHalfedge();
      back->setNeighbors(leaving, forth, sides[i + 1]->vertex(), cut, triangle);
      forth->setNeighbors(sides[i + 1], back, sides[0]->vertex(), cut, f);
      cut->halfedge() = back;
      triangle->halfedge() = back;
      leaving->face() = triangle;
      sides[i]->face() = triangle;
      sides[i]->next() = back;
      leaving = forth;
    }
    sides[n - 1]->next() = leaving;
    f->halfedge() = leaving;
  }
  // SOLUTION END
}

}  // namespace meshedit
