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
  static bool is_marked(const Mesh& mesh, Mesh::VertexRef v) {
    return mesh.verased.count(v) != 0;
  }
  static bool is_marked(const Mesh& mesh, Mesh::EdgeRef e) {
    return mesh.eerased.count(e) != 0;
  }
  static bool is_marked(const Mesh& mesh, Mesh::FaceRef f) {
    return mesh.ferased.count(f) != 0;
  }
  static bool is_marked(const Mesh& mesh, Mesh::HalfedgeRef h) {
    return mesh.herased.count(h) != 0;
  }
  /// What is left to do when a function of the homework has returned.
  static void finish(Mesh& mesh) {
    const StepPause pause;
    mesh.do_erase();
  }

  static Mesh::VertexRef make_vertex(Mesh& mesh) { return mesh.new_vertex(); }
  static Mesh::EdgeRef make_edge(Mesh& mesh) { return mesh.new_edge(); }
  static Mesh::FaceRef make_face(Mesh& mesh, bool boundary) { return mesh.new_face(boundary); }
  static Mesh::HalfedgeRef make_halfedge(Mesh& mesh) { return mesh.new_halfedge(); }

  template <class Vertex>
  static auto& position(Vertex& v) {
    return v.pos;
  }
  template <class Element>
  static auto& halfedge(Element& element) {
    return element._halfedge;
  }
  static bool is_boundary(const Mesh::Face& f) { return f.boundary; }
  static Mesh::HalfedgeCRef twin(const Mesh::Halfedge& h) { return h._twin; }
  static Mesh::HalfedgeCRef next(const Mesh::Halfedge& h) { return h._next; }
  static Mesh::VertexCRef vertex(const Mesh::Halfedge& h) { return h._vertex; }
  static Mesh::EdgeCRef edge(const Mesh::Halfedge& h) { return h._edge; }
  static Mesh::FaceCRef face(const Mesh::Halfedge& h) { return h._face; }
  static void connect(Mesh::Halfedge& h, Mesh::HalfedgeRef twin, Mesh::HalfedgeRef next,
                      Mesh::VertexRef vertex, Mesh::EdgeRef edge, Mesh::FaceRef face) {
    h.set_neighbors(next, twin, vertex, edge, face);
  }
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
