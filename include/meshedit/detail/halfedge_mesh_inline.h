#pragma once

// Bodies of the members declared in halfedge_mesh.h that are worth inlining. The others are in
// halfedge_mesh.cpp.

#include "../halfedge_mesh.h"

namespace meshedit {

namespace detail {

inline Halfedge* Element::getHalfedge() {
  return tag_.kind() == ElementKind::kHalfedge ? static_cast<Halfedge*>(this) : nullptr;
}
inline Vertex* Element::getVertex() {
  return tag_.kind() == ElementKind::kVertex ? static_cast<Vertex*>(this) : nullptr;
}
inline Edge* Element::getEdge() {
  return tag_.kind() == ElementKind::kEdge ? static_cast<Edge*>(this) : nullptr;
}
inline Face* Element::getFace() {
  return tag_.kind() == ElementKind::kFace ? static_cast<Face*>(this) : nullptr;
}

}  // namespace detail

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
  detail::Added<Edge>::operator=(other);
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

template <class T>
void HalfedgeMesh::remove(detail::Pool<T>& pool, const Handle<T>& handle) {
  T* element = &*handle;
  if (pool.find(element) < 0) {
    detail::raise_fault(FaultKind::kForeignHandle, T::kHandleName);
  }
  pool.remove(element);
}

}  // namespace meshedit
