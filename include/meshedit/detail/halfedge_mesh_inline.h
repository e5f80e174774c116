#pragma once

// Bodies of the members declared in halfedge_mesh.h.

#include <atomic>

#include "inspector.h"
#include "mesh_builder.h"

namespace meshedit {

inline bool Halfedge::isBoundary() const {
  return face()->isBoundary();
}

template <class T>
void Halfedge::refuse_foreign(const Handle<T>& handle) const {
  const bool known = handle.element_ != nullptr && handle.element_->tag_.mesh() != 0;
  if (known && tag_.mesh() != 0 && handle.element_->tag_.mesh() != tag_.mesh()) {
    detail::raise_fault(FaultKind::kForeignHandle, T::kHandleName);
  }
}

inline void Halfedge::setNeighbors(HalfedgeIter next, HalfedgeIter twin, VertexIter vertex,
                                   EdgeIter edge, FaceIter face) {
#ifndef MESHEDIT_UNCHECKED
  refuse_foreign(next);
  refuse_foreign(twin);
  refuse_foreign(vertex);
  refuse_foreign(edge);
  refuse_foreign(face);
#endif
  _next = next;
  _twin = twin;
  _vertex = vertex;
  _edge = edge;
  _face = face;
}

inline bool Vertex::isBoundary() const {
  HalfedgeCIter h = halfedge();
  do {
    if (h->isBoundary()) return true;
    h = h->twin()->next();
  } while (h != halfedge());
  return false;
}

inline Size Vertex::degree() const {
  Size faces_around = 0;
  HalfedgeCIter h = halfedge();
  do {
    if (!h->isBoundary()) ++faces_around;
    h = h->twin()->next();
  } while (h != halfedge());
  return faces_around;
}

inline Edge::Edge(EdgeRecord& place, const Edge& other) : Edge(place) {
  *this = other;
}

inline Edge& Edge::operator=(const Edge& other) {
  _halfedge = other._halfedge;
  isNew = other.isNew;
  newPosition = other.newPosition;
  record = other.record;
  return *this;
}

inline bool Edge::isBoundary() const {
  return halfedge()->isBoundary() || halfedge()->twin()->isBoundary();
}

inline double Edge::length() const {
  const Vector3D a = halfedge()->vertex()->position;
  const Vector3D b = halfedge()->twin()->vertex()->position;
  return (b - a).norm();
}

inline Size Face::degree() const {
  Size corners = 0;
  HalfedgeCIter h = halfedge();
  do {
    ++corners;
    h = h->next();
  } while (h != halfedge());
  return corners;
}

inline Vector3D Face::normal() const {
  Vector3D sum;
  HalfedgeCIter h = halfedge();
  const Vector3D corner = h->vertex()->position;
  do {
    sum += cross(h->vertex()->position - corner, h->next()->vertex()->position - corner);
    h = h->next();
  } while (h != halfedge());
  return sum.unit();
}

namespace detail {

inline std::uint32_t next_mesh_serial() {
  static std::atomic<std::uint32_t> last{0};
  return ++last;
}

template <class T>
void print_if_same(const Handle<T>& a, const Handle<T>& b, const char* kind,
                   const void* address, const char* member) {
  if (a == b) std::cout << kind << " " << address << " points to it by " << member << "\n";
}

}  // namespace detail

inline HalfedgeMesh::HalfedgeMesh() : serial_(detail::next_mesh_serial()) {}

inline HalfedgeMesh::HalfedgeMesh(const HalfedgeMesh& mesh) : HalfedgeMesh() {
  *this = mesh;
}

inline HalfedgeMesh& HalfedgeMesh::operator=(const HalfedgeMesh& mesh) {
  if (this != &mesh) detail::Inspector::copy(mesh, *this);
  return *this;
}

inline void HalfedgeMesh::build(const std::vector<std::vector<Index>>& polygons,
                                const std::vector<Vector3D>& vertexPositions) {
  detail::MeshBuilder(polygons, vertexPositions).build(*this);
}

template <class T>
void HalfedgeMesh::remove(detail::Pool<T>& pool, const Handle<T>& handle) {
  T* element = &*handle;
  if (pool.find(element) < 0) {
    detail::raise_fault(FaultKind::kForeignHandle, T::kHandleName);
  }
  pool.remove(element);
}

inline void HalfedgeMesh::check_for(HalfedgeIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    detail::print_if_same(h->twin(), target, "half-edge", elementAddress(h), "twin");
    detail::print_if_same(h->next(), target, "half-edge", elementAddress(h), "next");
  }
  for (VertexIter v = verticesBegin(); v != verticesEnd(); ++v) {
    detail::print_if_same(v->halfedge(), target, "vertex", elementAddress(v), "halfedge");
  }
  for (EdgeIter e = edgesBegin(); e != edgesEnd(); ++e) {
    detail::print_if_same(e->halfedge(), target, "edge", elementAddress(e), "halfedge");
  }
  for (FaceIter f = facesBegin(); f != facesEnd(); ++f) {
    detail::print_if_same(f->halfedge(), target, "face", elementAddress(f), "halfedge");
  }
  for (FaceIter b = boundariesBegin(); b != boundariesEnd(); ++b) {
    detail::print_if_same(b->halfedge(), target, "boundary", elementAddress(b), "halfedge");
  }
}

inline void HalfedgeMesh::check_for(VertexIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    detail::print_if_same(h->vertex(), target, "half-edge", elementAddress(h), "vertex");
  }
}

inline void HalfedgeMesh::check_for(EdgeIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    detail::print_if_same(h->edge(), target, "half-edge", elementAddress(h), "edge");
  }
}

inline void HalfedgeMesh::check_for(FaceIter target) {
  for (HalfedgeIter h = halfedgesBegin(); h != halfedgesEnd(); ++h) {
    detail::print_if_same(h->face(), target, "half-edge", elementAddress(h), "face");
  }
}

}  // namespace meshedit
