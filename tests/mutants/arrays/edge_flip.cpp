#include "meshedit/meshedit.h"

namespace meshedit {

// The flip by a list of the six half-edges inside the diamond, and a table.
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  if (e0->isBoundary()) return e0;
  std::vector<HalfedgeIter> in;
  for (HalfedgeIter start : {e0->halfedge(), e0->halfedge()->twin()}) {
    HalfedgeIter h = start;
    do {
      in.push_back(h);
      h = h->next();
    } while (h != start);
  }
  std::vector<VertexIter> v;
  for (HalfedgeIter h : in) {
    v.push_back(h->vertex());
  }
  FaceIter left = in[0]->face();
  FaceIter right = in[3]->face();

  const int next[] = {2, 3, 4, 5, 0, 1};
  v[0] = v[5];
  v[3] = v[2];
  for (int i = 0; i < 6; i++) {
    in[i]->next() = in[next[i]];
    in[i]->vertex() = v[i];
    in[i]->face() = i % 2 == 0 ? left : right;
    v[i]->halfedge() = in[i];
  }
  left->halfedge() = in[0];
  right->halfedge() = in[3];
  return e0;
  // SOLUTION END
}

}  // namespace meshedit
