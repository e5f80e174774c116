#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE vertex_bevel: put a face in the place of a vertex.
//
//            c                            c
//            |                            |
//            |                            o
//            |                           / `.
//            v                          /  f `.
//          /   `.                      o ----- o
//        /       `.                  /           `.
//      a            b              a                b
//
// Each edge at v gets an end of its own, AT THE PLACE OF v: how far it moves is for later.
// These are the corners of the new face, and its sides lie between the faces that were around
// v. On a boundary, the last side lies on the boundary. v itself goes; it may also become a
// corner.
//
// Look first, and return std::nullopt without a change, if v has two edges only.
std::optional<FaceIter> PolyMesh::bevelVertex(VertexIter v) {
  // SOLUTION BEGIN PolyMesh::bevelVertex
  std::vector<HalfedgeIter> spokes;
  HalfedgeIter h = v->halfedge();
  do {
    spokes.push_back(h);
    h = h->twin()->next();
  } while (h != v->halfedge());
  const Size n = spokes.size();
  if (n < 3) return std::nullopt;

  const FaceIter face = newFace();
  std::vector<HalfedgeIter> outer;  // [i] from the end of spoke i to that of spoke i + 1
  std::vector<HalfedgeIter> inner;  // [i] its twin, in the new face
  std::vector<EdgeIter> edges;
  for (HalfedgeIter spoke : spokes) {
    outer.push_back(newHalfedge());
    inner.push_back(newHalfedge());
    edges.push_back(newEdge());
    const VertexIter end = newVertex();
    end->position = v->position;
    end->halfedge() = spoke;
    spoke->vertex() = end;
  }
  for (Size i = 0; i < n; ++i) {
    const Size next = (i + 1) % n;
    const Size before = (i + n - 1) % n;
    const HalfedgeIter in = spokes[i]->twin();
    outer[i]->setNeighbors(spokes[next], inner[i], spokes[i]->vertex(), edges[i], in->face());
    inner[i]->setNeighbors(inner[before], outer[i], spokes[next]->vertex(), edges[i], face);
    edges[i]->halfedge() = inner[i];
    in->next() = outer[i];
  }
  face->halfedge() = inner[0];
  deleteVertex(v);
  return face;
  // SOLUTION END
}

}  // namespace meshedit
