// A program to try your functions in, by hand or in a debugger. It is not graded and not handed
// in: change whatever you like.

#include <iostream>

#include "meshedit/meshedit.h"

namespace {

using namespace meshedit;

// Numbers for the elements, in the order of their lists.
Index numberOf(HalfedgeMesh& mesh, VertexCIter v) {
  Index number = 0;
  for (VertexIter w = mesh.verticesBegin(); w != v; ++w) {
    ++number;
  }
  return number;
}

void print(HalfedgeMesh& mesh) {
  std::cout << mesh.nVertices() << " vertices, " << mesh.nEdges() << " edges, " << mesh.nFaces()
            << " faces, " << mesh.nHalfedges() << " half-edges\n";
  for (FaceIter f = mesh.facesBegin(); f != mesh.facesEnd(); ++f) {
    std::cout << "  face:";
    HalfedgeIter h = f->halfedge();
    do {
      std::cout << " v" << numberOf(mesh, h->vertex()) << " " << h->vertex()->position;
      h = h->next();
    } while (h != f->halfedge());
    std::cout << "\n";
  }
}

}  // namespace

int main() {
  // Two triangles with the common edge b - c; the picture is in edge_flip.cpp.
  const Vector3D a(0, 1, 0);
  const Vector3D b(-1, 0, 0);
  const Vector3D c(1, 0, 0);
  const Vector3D d(0, -1, 0);
  HalfedgeMesh mesh;
  mesh.build({{0, 1, 2}, {3, 2, 1}}, {a, b, c, d});
  print(mesh);

  for (EdgeIter e = mesh.edgesBegin(); e != mesh.edgesEnd(); ++e) {
    if (!e->isBoundary()) {
      mesh.flipEdge(e);
      break;
    }
  }
  print(mesh);
}
