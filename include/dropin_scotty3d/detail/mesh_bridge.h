#pragma once

// Makes a Halfedge_Mesh of one of our meshes, and writes back what became of it: so the grader
// sees what a function of the homework did as if one of ours had done it. Homework of different
// years has different meshes; mesh_access.h of each says where its elements keep what they
// hold.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "../lib/vec3.h"
#include "element_list.h"
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

/// A position that floats cannot hold stays what it is until it is changed.
inline void write_position(const Vec3& from, Vector3D& to) {
  const Vec3 known = to_floats(to);
  const bool is_same = known.x == from.x && known.y == from.y && known.z == from.z;
  if (!is_same) to = Vector3D(from.x, from.y, from.z);
}

/// Elements of a mesh that no case has: where pointers into other meshes lead.
struct StrayElements {
  StrayElements() {
    const StepPause pause;
    vertex = elementAddress(mesh.newVertex());
    edge = elementAddress(mesh.newEdge());
    face = elementAddress(mesh.newFace());
    halfedge = elementAddress(mesh.newHalfedge());
  }

  HalfedgeMesh mesh;
  Vertex* vertex;
  Edge* edge;
  Face* face;
  Halfedge* halfedge;
};

inline StrayElements& strays() {
  static StrayElements elements;
  return elements;
}

/// A Halfedge_Mesh with the elements of one of our meshes, and the way back. Both meshes have
/// to live as long.
/// @tparam Access  of the year: see mesh_access.h
template <class Access>
class MeshBridge {
 public:
  using Mesh = typename Access::Mesh;
  using TheirVertex = typename Mesh::Vertex;
  using TheirEdge = typename Mesh::Edge;
  using TheirFace = typename Mesh::Face;
  using TheirHalfedge = typename Mesh::Halfedge;

  /// @param theirs  an empty mesh
  MeshBridge(HalfedgeMesh& ours, Mesh& theirs)
      : mesh_(ours),
        vertices_(theirs.vertices),
        edges_(theirs.edges),
        faces_(theirs.faces),
        halfedges_(theirs.halfedges) {
    const StepPause pause;
    vertices_.fill(Inspector::vertices(mesh_), [&] { return Access::make_vertex(theirs); });
    faces_.fill(Inspector::faces(mesh_), [&] { return Access::make_face(theirs, false); });
    faces_.fill(Inspector::boundaries(mesh_), [&] { return Access::make_face(theirs, true); });
    edges_.fill(Inspector::edges(mesh_), [&] { return Access::make_edge(theirs); });
    halfedges_.fill(Inspector::halfedges(mesh_), [&] { return Access::make_halfedge(theirs); });
    fill_pointers();
  }

  Reference<TheirVertex> theirs(const VertexIter& v) const {
    return vertices_.theirs(Inspector::address(v));
  }
  Reference<TheirEdge> theirs(const EdgeIter& e) const {
    return edges_.theirs(Inspector::address(e));
  }
  Reference<TheirFace> theirs(const FaceIter& f) const {
    return faces_.theirs(Inspector::address(f));
  }

  /// Makes our mesh what theirs has become. What lives on keeps its place, and exactly its
  /// position if that was not changed; what is new comes last; what was erased is deleted.
  void write_back() {
    const StepPause pause;
    settle_vertices();
    settle_edges();
    settle_faces();
    settle_halfedges();
    write_pointers();
  }

  /// After write_back().
  VertexIter ours(const Reference<const TheirVertex>& v) const {
    return vertices_.ours(v, strays().vertex);
  }
  EdgeIter ours(const Reference<const TheirEdge>& e) const {
    return edges_.ours(e, strays().edge);
  }
  FaceIter ours(const Reference<const TheirFace>& f) const {
    return faces_.ours(f, strays().face);
  }

 private:
  HalfedgeIter ours(const Reference<const TheirHalfedge>& h) const {
    return halfedges_.ours(h, strays().halfedge);
  }

  void fill_pointers() {
    const auto halfedge_of = [&](const auto& element) {
      return halfedges_.theirs(Inspector::halfedge(element));
    };
    vertices_.for_each([&](const Vertex& from, TheirVertex& to) {
      Access::position(to) = to_floats(from.position);
      Access::halfedge(to) = halfedge_of(from);
    });
    edges_.for_each(
        [&](const Edge& from, auto& to) { Access::halfedge(to) = halfedge_of(from); });
    faces_.for_each(
        [&](const Face& from, auto& to) { Access::halfedge(to) = halfedge_of(from); });
    halfedges_.for_each([&](const Halfedge& from, TheirHalfedge& to) {
      Access::connect(
          to, halfedges_.theirs(Inspector::twin(from)),
          halfedges_.theirs(Inspector::next(from)), vertices_.theirs(Inspector::vertex(from)),
          edges_.theirs(Inspector::edge(from)), faces_.theirs(Inspector::face(from)));
    });
  }

  void settle_vertices() {
    const auto remove = [&](Vertex* v) { mesh_.deleteVertex(Inspector::handle(v)); };
    vertices_.settle(
        [](Vertex* v, const TheirVertex& from) {
          write_position(Access::position(from), v->position);
          return v;
        },
        remove,
        [&](const TheirVertex& from, bool is_live) {
          Vertex* v = elementAddress(mesh_.newVertex());
          const Vec3 at = Access::position(from);
          v->position = Vector3D(at.x, at.y, at.z);
          if (!is_live) remove(v);
          return v;
        });
  }

  void settle_edges() {
    const auto remove = [&](Edge* e) { mesh_.deleteEdge(Inspector::handle(e)); };
    edges_.settle([](Edge* e, const TheirEdge& /*from*/) { return e; }, remove,
                  [&](const TheirEdge& /*from*/, bool is_live) {
                    Edge* e = elementAddress(mesh_.newEdge());
                    if (!is_live) remove(e);
                    return e;
                  });
  }

  /// Ours are in two lists: a face that has become a boundary, or the other way, is another
  /// one.
  void settle_faces() {
    const auto remove = [&](Face* f) {
      f->isBoundary() ? mesh_.deleteBoundary(Inspector::handle(f))
                      : mesh_.deleteFace(Inspector::handle(f));
    };
    const auto make = [&](bool boundary) {
      return elementAddress(boundary ? mesh_.newBoundary() : mesh_.newFace());
    };
    faces_.settle(
        [&](Face* f, const TheirFace& from) {
          if (f->isBoundary() == Access::is_boundary(from)) return f;
          remove(f);
          return make(Access::is_boundary(from));
        },
        remove,
        [&](const TheirFace& from, bool is_live) {
          Face* f = make(Access::is_boundary(from));
          if (!is_live) remove(f);
          return f;
        });
  }

  void settle_halfedges() {
    const auto remove = [&](Halfedge* h) { mesh_.deleteHalfedge(Inspector::handle(h)); };
    halfedges_.settle([](Halfedge* h, const TheirHalfedge& /*from*/) { return h; }, remove,
                      [&](const TheirHalfedge& /*from*/, bool is_live) {
                        Halfedge* h = elementAddress(mesh_.newHalfedge());
                        if (!is_live) remove(h);
                        return h;
                      });
  }

  void write_pointers() {
    vertices_.for_each(
        [&](Vertex& to, const auto& from) { to.halfedge() = ours(Access::halfedge(from)); });
    edges_.for_each(
        [&](Edge& to, const auto& from) { to.halfedge() = ours(Access::halfedge(from)); });
    faces_.for_each(
        [&](Face& to, const auto& from) { to.halfedge() = ours(Access::halfedge(from)); });
    halfedges_.for_each([&](Halfedge& to, const TheirHalfedge& from) {
      to.twin() = ours(Access::twin(from));
      to.next() = ours(Access::next(from));
      to.vertex() = ours(Access::vertex(from));
      to.edge() = ours(Access::edge(from));
      to.face() = ours(Access::face(from));
    });
  }

  HalfedgeMesh& mesh_;
  Pairing<Vertex, TheirVertex> vertices_;
  Pairing<Edge, TheirEdge> edges_;
  Pairing<Face, TheirFace> faces_;
  Pairing<Halfedge, TheirHalfedge> halfedges_;
};

}  // namespace scotty3d
}  // namespace detail
}  // namespace meshedit
