// What is not worth inlining, compiled once and not in every student's file: the compiler spent
// more time on it than on a solution.

#include "../halfedge_mesh.h"

#include <atomic>

#include "inspector.h"
#include "mesh_builder.h"

namespace meshedit {

namespace detail {

void Inspector::copy(const HalfedgeMesh& from, HalfedgeMesh& to) {
  const auto halfedges = copy_elements(from.halfedges, to.halfedges, to.serial_);
  const auto vertices = copy_elements(from.vertices, to.vertices, to.serial_);
  const auto edges = copy_elements(from.edges, to.edges, to.serial_);
  const auto faces = copy_elements(from.faces, to.faces, to.serial_);
  const auto boundaries = copy_elements(from.boundaries, to.boundaries, to.serial_);
  for (Halfedge* h : halfedges) {
    if (h == nullptr) continue;
    redirect(h->_twin, from.halfedges, halfedges);
    redirect(h->_next, from.halfedges, halfedges);
    redirect(h->_vertex, from.vertices, vertices);
    redirect(h->_edge, from.edges, edges);
    const bool outside = from.boundaries.find(h->_face.element_) >= 0;
    redirect(h->_face, outside ? from.boundaries : from.faces, outside ? boundaries : faces);
  }
  const auto redirect_all = [&](const auto& elements) {
    for (auto* element : elements) {
      if (element != nullptr) redirect(element->_halfedge, from.halfedges, halfedges);
    }
  };
  redirect_all(vertices);
  redirect_all(edges);
  redirect_all(faces);
  redirect_all(boundaries);
  for (Edge* e : edges) {
    if (e != nullptr) redirect(e->record.edge, from.edges, edges);
  }
}

}  // namespace detail

namespace {

std::uint32_t next_mesh_serial() {
  static std::atomic<std::uint32_t> last{0};
  return ++last;
}

EdgeRecord& shared_record() {
  static EdgeRecord record;
  return record;
}

template <class T>
void print_if_same(const Handle<T>& a, const Handle<T>& b, const char* kind,
                   const void* address, const char* member) {
  if (a == b) std::cout << kind << " " << address << " points to it by " << member << "\n";
}

}  // namespace

Edge::Edge() : Edge(shared_record()) {}

HalfedgeMesh::HalfedgeMesh() : detail::Added<HalfedgeMesh>(), serial_(next_mesh_serial()) {
  halfedges.set_mesh(serial_);
  vertices.set_mesh(serial_);
  edges.set_mesh(serial_);
  faces.set_mesh(serial_);
  boundaries.set_mesh(serial_);
}

HalfedgeMesh::HalfedgeMesh(const HalfedgeMesh& mesh) : HalfedgeMesh() {
  *this = mesh;
}

HalfedgeMesh& HalfedgeMesh::operator=(const HalfedgeMesh& mesh) {
  if (this == &mesh) return *this;
  detail::Added<HalfedgeMesh>::operator=(mesh);
  detail::Inspector::copy(mesh, *this);
  return *this;
}

void HalfedgeMesh::build(const std::vector<std::vector<Index>>& polygons,
                         const std::vector<Vector3D>& vertexPositions) {
  detail::MeshBuilder(polygons, vertexPositions).build(*this);
}

void HalfedgeMesh::check_for(HalfedgeIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    print_if_same(h->twin(), target, "half-edge", elementAddress(h), "twin");
    print_if_same(h->next(), target, "half-edge", elementAddress(h), "next");
  }
  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) {
    print_if_same(v->halfedge(), target, "vertex", elementAddress(v), "halfedge");
  }
  for (EdgeIter e = edgesBegin(); e != edgesEnd(); ++e) {
    print_if_same(e->halfedge(), target, "edge", elementAddress(e), "halfedge");
  }
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f) {
    print_if_same(f->halfedge(), target, "face", elementAddress(f), "halfedge");
  }
  for (FaceIter b = boundariesBegin(); b != boundariesEnd(); ++b) {
    print_if_same(b->halfedge(), target, "boundary", elementAddress(b), "halfedge");
  }
}

void HalfedgeMesh::check_for(VertexIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    print_if_same(h->vertex(), target, "half-edge", elementAddress(h), "vertex");
  }
}

void HalfedgeMesh::check_for(EdgeIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    print_if_same(h->edge(), target, "half-edge", elementAddress(h), "edge");
  }
}

void HalfedgeMesh::check_for(FaceIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    print_if_same(h->face(), target, "half-edge", elementAddress(h), "face");
  }
}

}  // namespace meshedit
