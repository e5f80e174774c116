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
  // SOLUTION BEGIN PolyMesh::insetVertex
  std::vector<HalfedgeIter> sides;
  Vector3D sum;
  HalfedgeIter h = f->halfedge();
  do {
    sides.push_back(h);
    sum += h->vertex()->position;
    h = h->next();
  } while (h != f->halfedge());

  const Size n = sides.size();
  const VertexIter m = newVertex();
  m->position = sum / static_cast<double>(n);
  std::vector<HalfedgeIter> inward;   // [i] from the corner where side i ends to m
  std::vector<HalfedgeIter> outward;  // [i] from m to the corner where side i starts
  for (Size i = 0; i < n; ++i) {
    inward.push_back(newHalfedge());
    outward.push_back(newHalfedge());
  }
  for (Size i = 0; i < n; ++i) {
    const Size before = (i + n - 1) % n;
    const FaceIter triangle = i == 0 ? f : newFace();
    const EdgeIter spoke = newEdge();  // at the corner where side i starts
    outward[i]->setNeighbors(sides[i], inward[before], m, spoke, triangle);
    inward[i]->setNeighbors(outward[i], outward[(i + 1) % n], sides[(i + 1) % n]->vertex(),
                            EdgeIter(), triangle);
    spoke->halfedge() = outward[i];
    sides[i]->next() = inward[i];
    sides[i]->face() = triangle;
    triangle->halfedge() = sides[i];
  }
  for (Size i = 0; i < n; ++i)
    inward[i]->edge() = outward[(i + 1) % n]->edge();
  m->halfedge() = outward[0];
  return m;
  // SOLUTION END
}

}  // namespace meshedit
