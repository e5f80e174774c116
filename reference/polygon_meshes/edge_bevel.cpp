#include "meshedit/meshedit.h"

namespace meshedit {

// SOLUTION BEGIN
namespace {

// The half-edges that leave the end of h but for its twin, in the order in which they follow
// each other around the edge.
void addOthersAtEnd(HalfedgeIter h, std::vector<HalfedgeIter>& others) {
  for (HalfedgeIter k = h->next(); k != h->twin(); k = k->twin()->next())
    others.push_back(k);
}

}  // namespace
// SOLUTION END

// EXERCISE edge_bevel: put a face in the place of an edge.
//
//      o               o        o                     o
//       `.           .'          `.                 .'
//         a ------- b              o ------------- o
//       .'           `.            |       f       |
//      o               o           o ------------- o
//                                .'                 `.
//                               o                     o
//
// Each OTHER edge at a and at b gets an end of its own, AT THE PLACE OF a or b: how far it
// moves is for later. These are the corners of the new face: if a has 4 edges and b has 3, it
// has 3 + 2 corners. The edge, a and b go.
//
// Look first, and return std::nullopt without a change, if the edge lies on a boundary, or if
// both of its ends have two edges only. With one such end, both is right.
std::optional<FaceIter> PolyMesh::bevelEdge(EdgeIter e) {
  // SOLUTION BEGIN PolyMesh::bevelEdge
  const HalfedgeIter h = e->halfedge();
  const HalfedgeIter t = h->twin();
  const VertexIter a = h->vertex();
  const VertexIter b = t->vertex();
  std::vector<HalfedgeIter> spokes;
  addOthersAtEnd(h, spokes);
  addOthersAtEnd(t, spokes);
  const Size n = spokes.size();
  if (e->isBoundary() || n < 3) return std::nullopt;

  const FaceIter face = newFace();
  std::vector<FaceIter> around;     // [i] the face behind spoke i
  std::vector<HalfedgeIter> outer;  // [i] from the end of spoke i to that of spoke i + 1
  std::vector<HalfedgeIter> inner;  // [i] its twin, in the new face
  std::vector<EdgeIter> edges;
  for (HalfedgeIter spoke : spokes) {
    around.push_back(spoke->twin()->face());
    outer.push_back(newHalfedge());
    inner.push_back(newHalfedge());
    edges.push_back(newEdge());
    const VertexIter end = newVertex();
    end->position = spoke->vertex()->position;
    end->halfedge() = spoke;
    spoke->vertex() = end;
  }
  for (Size i = 0; i < n; ++i) {
    const Size next = (i + 1) % n;
    const Size before = (i + n - 1) % n;
    outer[i]->setNeighbors(spokes[next], inner[i], spokes[i]->vertex(), edges[i], around[i]);
    inner[i]->setNeighbors(inner[before], outer[i], spokes[next]->vertex(), edges[i], face);
    edges[i]->halfedge() = inner[i];
    spokes[i]->twin()->next() = outer[i];
    around[i]->halfedge() = outer[i];
  }
  face->halfedge() = inner[0];
  deleteHalfedge(h);
  deleteHalfedge(t);
  deleteEdge(e);
  deleteVertex(a);
  deleteVertex(b);
  return face;
  // SOLUTION END
}

}  // namespace meshedit
