#include "meshedit/meshedit.h"

namespace meshedit {

// EXERCISE catmull_clark: where the vertices of the next level lie, by Catmull and Clark.
//
//   face f         the mean of its corners
//
//   edge a-b       (a + b + f + g) / 4, with the new vertices f, g of the faces beside it
//                  on a boundary: (a + b) / 2
//
//   vertex S       (Q + 2 R + (n - 3) S) / n      n edges
//                  Q  the mean of the new vertices of the faces around
//                  R  the mean of the middles of the edges at it (NOT of their new vertices)
//                  on a boundary: 3/4 S + 1/8 (a + b), a and b along the boundary
//
// Compute the positions only: the mesh stays as it is, and is cut elsewhere. Every vertex, edge
// and face has one; boundary loops have none.
RefinedPositions PolyMesh::catmullClarkPositions() {
  // SOLUTION BEGIN PolyMesh::catmullClarkPositions
  RefinedPositions refined;
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f) {
    Vector3D sum;
    HalfedgeIter h = f->halfedge();
    do {
      sum += h->vertex()->position;
      h = h->next();
    } while (h != f->halfedge());
    refined.faces[f] = sum / static_cast<double>(f->degree());
  }

  for (EdgeIter e = edgesBegin(); e != edgesEnd(); ++e) {
    const HalfedgeIter h = e->halfedge();
    const Vector3D ends = h->vertex()->position + h->twin()->vertex()->position;
    if (e->isBoundary()) {
      refined.edges[e] = 0.5 * ends;
    } else {
      const Vector3D beside = refined.faces[h->face()] + refined.faces[h->twin()->face()];
      refined.edges[e] = 0.25 * (ends + beside);
    }
  }

  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) {
    const Vector3D S = v->position;
    const bool boundary = v->isBoundary();
    double n = 0.0;
    Vector3D faces;
    Vector3D middles;
    Vector3D along;  // the neighbours along the boundary
    HalfedgeIter h = v->halfedge();
    do {
      const Vector3D neighbour = h->twin()->vertex()->position;
      n += 1.0;
      middles += 0.5 * (S + neighbour);
      if (h->edge()->isBoundary()) along += neighbour;
      if (!h->isBoundary()) faces += refined.faces[h->face()];
      h = h->twin()->next();
    } while (h != v->halfedge());
    const Vector3D Q = faces / n;
    const Vector3D R = middles / n;
    refined.vertices[v] =
        boundary ? 0.75 * S + 0.125 * along : (Q + 2.0 * R + (n - 3.0) * S) / n;
  }
  return refined;
  // SOLUTION END
}

}  // namespace meshedit
