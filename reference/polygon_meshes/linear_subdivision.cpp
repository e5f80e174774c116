#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE linear_subdivision: where the vertices of the next level lie, without smoothing.
//
//      o ------ o           v -- e -- v
//      |        |           |    |    |         v  an old vertex: it stays
//      |        |    ->     e -- f -- e         e  the middle of an edge
//      |        |           |    |    |         f  the mean of the corners of a face
//      o ------ o           v -- e -- v
//
// Compute the positions only: the mesh stays as it is, and is cut elsewhere. Every vertex, edge
// and face has one; boundary loops have none.
RefinedPositions PolyMesh::linearPositions() {
  // SOLUTION BEGIN PolyMesh::linearPositions
  RefinedPositions refined;
  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v)
    refined.vertices[v] = v->position;
  for (EdgeIter e = edgesBegin(); e != edgesEnd(); ++e) {
    const HalfedgeIter h = e->halfedge();
    refined.edges[e] = 0.5 * (h->vertex()->position + h->twin()->vertex()->position);
  }
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f) {
    Vector3D sum;
    HalfedgeIter h = f->halfedge();
    do {
      sum += h->vertex()->position;
      h = h->next();
    } while (h != f->halfedge());
    refined.faces[f] = sum / static_cast<double>(f->degree());
  }
  return refined;
  // SOLUTION END
}

}  // namespace meshedit
