#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE bevel_positions: place the corners of a face that bevelVertex() or bevelEdge() has
// made, while somebody drags it.
//
//              c                          c
//              |                          |
//              o  start                   |
//             / `.                        o  start + t u
//            /  f `.          ->        /   `.
//           o ----- o                 /   f   `.
//         /           `.            o --------- o
//       a                b        a               b
//
// starts[i] is where corner i was when the face was made, from the vertex of f->halfedge() on.
// The corner stays on its edge to the outer vertex: u is the unit vector from the start to
// that. It goes so far that it has gone `distance` IN THE DIRECTION: t = distance /
// dot(direction, u). `direction` has length 1. Each call begins at the starts.
void PolyMesh::placeBevelled(FaceIter f, const std::vector<Vector3D>& starts,
                             const Vector3D& direction, double distance) {
  // SOLUTION BEGIN PolyMesh::placeBevelled
  HalfedgeIter h = f->halfedge();
  for (const Vector3D& start : starts) {
    const VertexIter outer = h->twin()->next()->twin()->vertex();
    const Vector3D u = (outer->position - start).unit();
    h->vertex()->position = start + distance / dot(direction, u) * u;
    h = h->next();
  }
  // SOLUTION END
}

}  // namespace meshedit
