#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE face_extrude: make a copy of a face within it, and a ring of quads between the two.
//
//      p3 --------- p2        p3 --------- p2
//      |            |         | `q3 --- q2' |
//      |     f      |         |  |   f  |   |
//      |            |         |  |      |   |
//      |            |         | .q0 --- q1. |
//      p0 --------- p1        p0 --------- p1
//
// n corners: n new vertices, 2n new edges, n new faces. The new vertices lie AT THE SAME PLACES
// as the old corners: how far the copy moves is for later. Return the face in the middle.
std::optional<FaceIter> PolyMesh::extrudeFace(FaceIter f) {
  // SOLUTION BEGIN PolyMesh::extrudeFace
  std::vector<HalfedgeIter> sides;
  HalfedgeIter h = f->halfedge();
  do {
    sides.push_back(h);
    h = h->next();
  } while (h != f->halfedge());

  const Size n = sides.size();
  std::vector<VertexIter> corners;     // [i] the copy of the corner where side i starts
  std::vector<HalfedgeIter> inner;     // [i] in the middle, along side i
  std::vector<HalfedgeIter> opposite;  // [i] its twin, in the quad of side i
  std::vector<HalfedgeIter> inward;    // [i] in that quad, from the end of side i to its copy
  std::vector<HalfedgeIter> outward;   // [i] in that quad, from the copy of its start to it
  for (Size i = 0; i < n; ++i) {
    corners.push_back(newVertex());
    inner.push_back(newHalfedge());
    opposite.push_back(newHalfedge());
    inward.push_back(newHalfedge());
    outward.push_back(newHalfedge());
  }
  for (Size i = 0; i < n; ++i) {
    const Size next = (i + 1) % n;
    const FaceIter quad = newFace();
    const EdgeIter along = newEdge();
    const EdgeIter across = newEdge();  // at the corner where side i ends
    const VertexIter end = sides[next]->vertex();
    corners[i]->position = sides[i]->vertex()->position;
    corners[i]->halfedge() = inner[i];
    inner[i]->setNeighbors(inner[next], opposite[i], corners[i], along, f);
    opposite[i]->setNeighbors(outward[i], inner[i], corners[next], along, quad);
    inward[i]->setNeighbors(opposite[i], outward[next], end, across, quad);
    outward[next]->setNeighbors(sides[next], inward[i], corners[next], across, FaceIter());
    along->halfedge() = inner[i];
    across->halfedge() = inward[i];
    sides[i]->next() = inward[i];
    sides[i]->face() = quad;
    quad->halfedge() = sides[i];
  }
  for (Size i = 0; i < n; ++i)
    outward[i]->face() = sides[i]->face();
  f->halfedge() = inner[0];
  return f;
  // SOLUTION END
}

}  // namespace meshedit
