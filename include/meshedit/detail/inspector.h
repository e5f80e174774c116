#pragma once

// Looks at a mesh without trusting it: pointers are compared with the addresses of the elements
// that are there, and never followed. For the grader and for copying.

#include <cstddef>
#include <vector>

#include "../halfedge_mesh.h"

namespace meshedit {
namespace detail {

struct Inspector {
  static const Pool<Halfedge>& halfedges(const HalfedgeMesh& mesh) { return mesh.halfedges; }
  static const Pool<Vertex>& vertices(const HalfedgeMesh& mesh) { return mesh.vertices; }
  static const Pool<Edge>& edges(const HalfedgeMesh& mesh) { return mesh.edges; }
  static const Pool<Face>& faces(const HalfedgeMesh& mesh) { return mesh.faces; }
  static const Pool<Face>& boundaries(const HalfedgeMesh& mesh) { return mesh.boundaries; }

  static bool is_live(const Element& element) {
    return element.tag_.state() == SlotState::kLive;
  }
  template <class T>
  static const T* address(const Handle<T>& handle) {
    return handle.element_;
  }
  template <class T>
  static Handle<T> handle(T* element) {
    return Handle<T>(element);
  }

  static const Halfedge* twin(const Halfedge& h) { return h._twin.element_; }
  static const Halfedge* next(const Halfedge& h) { return h._next.element_; }
  static const Vertex* vertex(const Halfedge& h) { return h._vertex.element_; }
  static const Edge* edge(const Halfedge& h) { return h._edge.element_; }
  static const Face* face(const Halfedge& h) { return h._face.element_; }
  template <class T>
  static const Halfedge* halfedge(const T& element) {
    return element._halfedge.element_;
  }

  /// Makes `to` a deep copy of `from`. Deleted elements are left out; pointers that lead to no
  /// live element of `from` become unset.
  static void copy(const HalfedgeMesh& from, HalfedgeMesh& to);

 private:
  /// Appends copies of all live elements; entry i of the result is the copy of element i.
  template <class T>
  static std::vector<T*> copy_elements(const Pool<T>& from, Pool<T>& to, std::uint32_t mesh) {
    std::vector<T*> copies(from.slots(), nullptr);
    to.clear();
    for (std::size_t i = 0; i < from.slots(); ++i) {
      if (is_live(*from.at(i))) copies[i] = to.append(mesh, *from.at(i));
    }
    return copies;
  }

  template <class T>
  static void redirect(Handle<T>& handle, const Pool<T>& from, const std::vector<T*>& copies) {
    const std::ptrdiff_t index = from.find(handle.element_);
    handle = index < 0 ? Handle<T>() : Handle<T>(copies[static_cast<std::size_t>(index)]);
  }
};

}  // namespace detail
}  // namespace meshedit
