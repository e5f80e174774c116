#pragma once

// Makes a Halfedge_Mesh of one of our meshes, and writes back what became of it: so the grader
// sees what a function of the homework did as if one of ours had done it.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "../geometry/halfedge.h"
#include "meshedit/detail/inspector.h"
#include "meshedit/halfedge_mesh.h"

namespace meshedit {
namespace detail {
namespace scotty3d {

inline Vec3 to_floats(const Vector3D& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// The elements of one kind on both sides.
template <class Ours, class Theirs>
class Pairing {
 public:
  explicit Pairing(ElementList<Theirs>& list) : list_(list) {}

  /// Makes one of theirs for each live element of ours, by `make`.
  template <class Make>
  void fill(const Pool<Ours>& pool, Make make) {
    std::vector<Link*>& links = links_[&pool];
    links.assign(pool.slots(), nullptr);
    for (std::size_t i = 0; i < pool.slots(); ++i) {
      if (!Inspector::is_live(*pool.at(i))) continue;
      const Reference<Theirs> made = make();
      links[i] = made.link();
      old_.push_back({pool.at(i), made.link()->birth});
      pairs_.push_back({pool.at(i), static_cast<Node<Theirs>*>(made.link())});
    }
  }

  /// Calls `each(ours, theirs)` for all pairs that live.
  template <class Each>
  void for_each(Each each) const {
    for (const auto& [ours, theirs] : pairs_)
      each(*ours, theirs->element);
  }

  /// Theirs for one of ours; the end of their list for what leads to no live element.
  Reference<Theirs> theirs(const Ours* address) const {
    for (const auto& [pool, links] : links_) {
      const std::ptrdiff_t i = pool->find(address);
      if (i < 0 || links[static_cast<std::size_t>(i)] == nullptr) continue;
      return list_.reference_to(links[static_cast<std::size_t>(i)]);
    }
    return list_.end();
  }

  /// Calls `keep(ours, theirs)` for each pair both of which still live, and `remove(ours)` for
  /// what was erased there; then, in the order in which they were made there,
  /// `add(theirs, is_live)` for what is new. The last one returns ours for it.
  template <class Keep, class Remove, class Add>
  void settle(Keep keep, Remove remove, Add add) {
    pairs_.clear();
    std::vector<Node<Theirs>*> made;
    std::size_t place = 0;
    for (Node<Theirs>& node : list_.nodes()) {
      const Old* old = place < old_.size() ? &old_[place] : nullptr;
      ++place;
      const bool is_old = old != nullptr && old->birth == node.birth;
      if (!is_old) made.push_back(&node);
      if (is_old && node.state == LinkState::kLive) {
        pair(keep(old->element, node.element), node);
      } else if (old != nullptr) {
        remove(old->element);
        if (is_old) ours_[&node] = old->element;
      }
    }
    std::sort(made.begin(), made.end(),
              [](const auto* a, const auto* b) { return a->birth < b->birth; });
    for (Node<Theirs>* node : made)
      pair(add(node->element, node->state == LinkState::kLive), *node);
  }

  /// After settle(): ours for a pointer of theirs, which is not followed. An erased element is
  /// a deleted one, and the end of a list is no element; what is of no list here becomes
  /// `stray`.
  Handle<Ours> ours(const Reference<const Theirs>& reference, Ours* stray) const {
    const Link* link = reference.link();
    if (link == nullptr || list_.is_end(link)) return {};
    const auto found = ours_.find(link);
    return Inspector::handle(found == ours_.end() ? stray : found->second);
  }

 private:
  /// The element that has the node with the same place in the list's memory.
  struct Old {
    Ours* element;
    std::uint64_t birth;
  };

  void pair(Ours* ours, Node<Theirs>& theirs) {
    ours_[&theirs] = ours;
    if (theirs.state == LinkState::kLive) pairs_.push_back({ours, &theirs});
  }

  ElementList<Theirs>& list_;
  std::unordered_map<const Pool<Ours>*, std::vector<Link*>> links_;  ///< by place in the pool
  std::vector<Old> old_;
  std::vector<std::pair<Ours*, Node<Theirs>*>> pairs_;  ///< those that live
  std::unordered_map<const Link*, Ours*> ours_;
};

/// A Halfedge_Mesh with the elements of one of our meshes, and the way back. Both meshes have
/// to live as long.
class MeshBridge {
 public:
  /// @param theirs  an empty mesh
  MeshBridge(HalfedgeMesh& ours, Halfedge_Mesh& theirs);

  Reference<Halfedge_Mesh::Vertex> theirs(const VertexIter& v) const {
    return vertices_.theirs(Inspector::address(v));
  }
  Reference<Halfedge_Mesh::Edge> theirs(const EdgeIter& e) const {
    return edges_.theirs(Inspector::address(e));
  }
  Reference<Halfedge_Mesh::Face> theirs(const FaceIter& f) const {
    return faces_.theirs(Inspector::address(f));
  }

  /// Makes our mesh what theirs has become. What lives on keeps its place, and exactly its
  /// position if that was not changed; what is new comes last; what was erased is deleted.
  void write_back();

  /// After write_back().
  VertexIter ours(const Reference<const Halfedge_Mesh::Vertex>& v) const;
  EdgeIter ours(const Reference<const Halfedge_Mesh::Edge>& e) const;
  FaceIter ours(const Reference<const Halfedge_Mesh::Face>& f) const;

 private:
  HalfedgeIter ours(const Reference<const Halfedge_Mesh::Halfedge>& h) const;
  void fill_pointers();
  void settle_vertices();
  void settle_edges();
  void settle_faces();
  void settle_halfedges();
  void write_pointers();

  HalfedgeMesh& mesh_;
  Pairing<Vertex, Halfedge_Mesh::Vertex> vertices_;
  Pairing<Edge, Halfedge_Mesh::Edge> edges_;
  Pairing<Face, Halfedge_Mesh::Face> faces_;
  Pairing<Halfedge, Halfedge_Mesh::Halfedge> halfedges_;
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
