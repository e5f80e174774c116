#pragma once

// What Halfedge_Mesh::validate() looks at.

#include <optional>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "element_list.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

/// Looks at a mesh that may be broken: a pointer is followed only once it is known to lead to a
/// live element of this mesh.
/// @tparam Access  of the year: see mesh_access.h
/// @tparam Mesh  its mesh, const or not
template <class Access, class Mesh>
class Validator {
 public:
  using Element = std::conditional_t<std::is_const<Mesh>::value, typename Mesh::ElementCRef,
                                     typename Mesh::ElementRef>;
  using Broken = std::optional<std::pair<Element, std::string>>;

  explicit Validator(Mesh& mesh) : mesh_(mesh) {
    add(mesh.vertices);
    add(mesh.edges);
    add(mesh.faces);
    add(mesh.halfedges);
  }

  /// The first element that breaks a rule, and which rule.
  Broken find() const {
    auto& halfedges = mesh_.halfedges;
    for (auto h = halfedges.begin(); h != halfedges.end(); ++h) {
      if (is_live(h) && !has_live_pointers(*h))
        return {{h, "a pointer of the half-edge leads to no live element"}};
    }
    for (auto h = halfedges.begin(); h != halfedges.end(); ++h) {
      const std::string trouble = is_live(h) ? trouble_of(h) : "";
      if (!trouble.empty()) return {{h, trouble}};
    }
    if (Broken broken = find_lost(mesh_.vertices)) return broken;
    if (Broken broken = find_lost(mesh_.edges)) return broken;
    return find_lost(mesh_.faces);
  }

 private:
  using HalfedgeCRef = typename Mesh::HalfedgeCRef;

  template <class List>
  void add(List& list) {
    for (auto element = list.begin(); element != list.end(); ++element) {
      if (!Access::is_marked(mesh_, element)) live_.insert(element.link());
    }
  }

  template <class T>
  bool is_live(const Reference<T>& reference) const {
    return live_.count(reference.link()) != 0;
  }

  bool has_live_pointers(const typename Mesh::Halfedge& h) const {
    return is_live(Access::twin(h)) && is_live(Access::next(h)) && is_live(Access::vertex(h)) &&
           is_live(Access::edge(h)) && is_live(Access::face(h));
  }

  static std::string trouble_of(const HalfedgeCRef& h) {
    const HalfedgeCRef twin = Access::twin(*h);
    const HalfedgeCRef next = Access::next(*h);
    if (twin == h || Access::twin(*twin) != h) return "the twin of its twin is another one";
    if (Access::edge(*twin) != Access::edge(*h)) return "its twin has another edge";
    if (Access::face(*next) != Access::face(*h)) return "the next one has another face";
    if (Access::vertex(*next) != Access::vertex(*twin))
      return "the next one does not start where it ends";
    if (Access::is_boundary(*Access::face(*h)) && Access::is_boundary(*Access::face(*twin)))
      return "no face is on either side";
    return {};
  }

  /// An element whose half-edge does not name it.
  template <class List>
  Broken find_lost(List& list) const {
    for (auto element = list.begin(); element != list.end(); ++element) {
      if (!is_live(element)) continue;
      const HalfedgeCRef h = Access::halfedge(*element);
      if (!is_live(h)) return {{element, "its half-edge leads to no live element"}};
      if (owner_of(*h, element) != element)
        return {{element, "its half-edge belongs to another element"}};
    }
    return std::nullopt;
  }

  static typename Mesh::VertexCRef owner_of(const typename Mesh::Halfedge& h,
                                            typename Mesh::VertexCRef /*kind*/) {
    return Access::vertex(h);
  }
  static typename Mesh::EdgeCRef owner_of(const typename Mesh::Halfedge& h,
                                          typename Mesh::EdgeCRef /*kind*/) {
    return Access::edge(h);
  }
  static typename Mesh::FaceCRef owner_of(const typename Mesh::Halfedge& h,
                                          typename Mesh::FaceCRef /*kind*/) {
    return Access::face(h);
  }

  Mesh& mesh_;
  std::unordered_set<const Link*> live_;
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
