#pragma once

// Where the elements of this year's Halfedge_Mesh keep what all years' elements have: for the
// code that homework of different years shares.

#include "geometry/halfedge.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

struct MeshAccess {
  using Mesh = Halfedge_Mesh;

  /// Whether an element of a list is to go, and has not gone yet.
  template <class T>
  static bool is_marked(const Mesh& /*mesh*/, const Reference<T>& /*element*/) {
    return false;
  }
  /// What is left to do when a function of the homework has returned.
  static void finish(Mesh& /*mesh*/) {}

  static Mesh::VertexRef make_vertex(Mesh& mesh) { return mesh.emplace_vertex(); }
  static Mesh::EdgeRef make_edge(Mesh& mesh) { return mesh.emplace_edge(); }
  static Mesh::FaceRef make_face(Mesh& mesh, bool boundary) {
    return mesh.emplace_face(boundary);
  }
  static Mesh::HalfedgeRef make_halfedge(Mesh& mesh) { return mesh.emplace_halfedge(); }

  template <class Vertex>
  static auto& position(Vertex& v) {
    return v.position;
  }
  template <class Element>
  static auto& halfedge(Element& element) {
    return element.halfedge;
  }
  static bool is_boundary(const Mesh::Face& f) { return f.boundary; }
  static auto twin(const Mesh::Halfedge& h) { return h.twin; }
  static auto next(const Mesh::Halfedge& h) { return h.next; }
  static auto vertex(const Mesh::Halfedge& h) { return h.vertex; }
  static auto edge(const Mesh::Halfedge& h) { return h.edge; }
  static auto face(const Mesh::Halfedge& h) { return h.face; }
  static void connect(Mesh::Halfedge& h, Mesh::HalfedgeRef twin, Mesh::HalfedgeRef next,
                      Mesh::VertexRef vertex, Mesh::EdgeRef edge, Mesh::FaceRef face) {
    h.set_tnvef(twin, next, vertex, edge, face);
  }
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
