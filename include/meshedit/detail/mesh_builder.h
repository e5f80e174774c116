#pragma once

// Builds a half-edge mesh from polygons, or says why they are not a surface. Linear time.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "../halfedge_mesh.h"

namespace meshedit {
namespace detail {

class MeshBuilder {
 public:
  MeshBuilder(const std::vector<std::vector<Index>>& polygons,
              const std::vector<Vector3D>& positions)
      : polygons_(polygons), positions_(positions) {}

  /// @throws MeshError, before `mesh` is touched
  void build(HalfedgeMesh& mesh) {
    number_corners();
    pair_corners();
    link_boundary();
    check_fans();
    fill(mesh);
  }

 private:
  // A corner is a place in a polygon, and stands for the half-edge that starts there.
  using Id = std::uint32_t;
  static constexpr Id kNone = UINT32_MAX;

  [[noreturn]] static void refuse(const std::string& what) { throw MeshError(what); }
  static std::string name(const char* kind, std::size_t index) {
    return kind + (" " + std::to_string(index));
  }

  void check_polygon(std::size_t p) const {
    const std::vector<Index>& corners = polygons_[p];
    if (corners.size() < 3) {
      refuse(name("polygon", p) + " has " + std::to_string(corners.size()) +
             " corners; it needs at least 3");
    }
    for (Index corner : corners) {
      if (corner < positions_.size()) continue;
      refuse(name("polygon", p) + " names vertex " + std::to_string(corner) +
             ", but there are only " + std::to_string(positions_.size()) + " vertices");
    }
  }

  /// Numbers the vertices in order of first appearance, and the corners one after the other.
  void number_corners() {
    std::vector<Id> last_polygon(positions_.size(), kNone);
    number_of_.assign(positions_.size(), kNone);
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      check_polygon(p);
      const Id first = static_cast<Id>(origin_.size());
      if (first + polygons_[p].size() > kMaxElements / 2) refuse("the mesh is too large");
      for (Index corner : polygons_[p]) {
        if (last_polygon[corner] == p) {
          refuse(name("polygon", p) + " has " + name("vertex", corner) +
                 " twice among its corners");
        }
        last_polygon[corner] = static_cast<Id>(p);
        if (number_of_[corner] == kNone) {
          number_of_[corner] = static_cast<Id>(input_of_.size());
          input_of_.push_back(static_cast<Id>(corner));
        }
        origin_.push_back(number_of_[corner]);
        next_.push_back(static_cast<Id>(origin_.size()));
        polygon_.push_back(static_cast<Id>(p));
      }
      next_.back() = first;
    }
    check_vertices();
  }

  void check_vertices() const {
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const Vector3D& p = positions_[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        refuse(name("vertex", i) + " has a position that is not a finite number");
      }
      if (number_of_[i] == kNone) refuse(name("vertex", i) + " is used by no polygon");
    }
  }

  Id target(Id corner) const { return origin_[next_[corner]]; }

  /// Finds the twin of each corner. Every edge waits for its second side in the list of the end
  /// point with fewer neighbours, which keeps the lists short even around a hub.
  void pair_corners() {
    const std::size_t n = origin_.size();
    std::vector<Id> degree(input_of_.size(), 0);
    for (Id c = 0; c < n; ++c) {
      ++degree[origin_[c]];
      ++degree[target(c)];
    }
    std::vector<Id> waiting(input_of_.size(), kNone);
    std::vector<Id> after(n, kNone);
    twin_.assign(n, kNone);
    for (Id c = 0; c < n; ++c) {
      const Id a = origin_[c];
      const Id b = target(c);
      const bool at_a = degree[a] < degree[b] || (degree[a] == degree[b] && a < b);
      Id& list = waiting[at_a ? a : b];
      Id other = list;
      while (other != kNone && !joins(other, a, b))
        other = after[other];
      if (other == kNone) {
        after[c] = list;
        list = c;
      } else {
        pair(c, other);
      }
    }
  }

  bool joins(Id corner, Id a, Id b) const {
    const Id from = origin_[corner];
    const Id to = target(corner);
    return (from == a && to == b) || (from == b && to == a);
  }

  void pair(Id corner, Id other) {
    const bool same_direction = origin_[corner] == origin_[other];
    if (same_direction || twin_[other] != kNone) {
      const Id used = same_direction ? other : twin_[other];
      refuse(edge_name(corner) + " is used in this direction by " +
             name("polygon", polygon_[used]) + " and again by " +
             name("polygon", polygon_[corner]) +
             "; an edge joins at most two polygons, and neighbours go along it in opposite "
             "directions");
    }
    twin_[corner] = other;
    twin_[other] = corner;
  }

  std::string edge_name(Id corner) const {
    return "edge " + std::to_string(input_of_[origin_[corner]]) + " -> " +
           std::to_string(input_of_[target(corner)]);
  }

  /// Gives every side without a twin a boundary half-edge, and links these to loops.
  void link_boundary() {
    const Id inside = static_cast<Id>(origin_.size());
    std::vector<Id> leaving(input_of_.size(), kNone);
    for (Id c = 0; c < inside; ++c) {
      if (twin_[c] != kNone) continue;
      const Id start = target(c);
      if (leaving[start] != kNone) refuse_bow_tie(start);
      leaving[start] = static_cast<Id>(twin_.size());
      twin_[c] = leaving[start];
      twin_.push_back(c);
    }
    for (Id b = inside; b < twin_.size(); ++b)
      next_.push_back(leaving[origin_[twin_[b]]]);
    boundary_leaving_ = std::move(leaving);
  }

  [[noreturn]] void refuse_bow_tie(Id vertex) const {
    refuse(name("vertex", input_of_[vertex]) +
           " joins fans of polygons that share no edge there (a bow-tie); each fan needs a "
           "vertex of its own");
  }

  Id start_of(Id h) const { return h < origin_.size() ? origin_[h] : target(twin_[h]); }

  /// A walk around each vertex must meet every half-edge that leaves it.
  void check_fans() {
    std::vector<Id> leaving(input_of_.size(), 0);
    first_leaving_.assign(input_of_.size(), kNone);
    for (Id h = 0; h < twin_.size(); ++h) {
      const Id v = start_of(h);
      ++leaving[v];
      if (first_leaving_[v] == kNone) first_leaving_[v] = h;
    }
    for (Id v = 0; v < input_of_.size(); ++v) {
      Id met = 0;
      Id h = first_leaving_[v];
      do {
        ++met;
        h = next_[twin_[h]];
      } while (h != first_leaving_[v] && met <= leaving[v]);
      if (met != leaving[v]) refuse_bow_tie(v);
    }
  }

  void fill(HalfedgeMesh& mesh) {
    const StepPause uncounted;
    mesh.halfedges.clear();
    mesh.vertices.clear();
    mesh.edges.clear();
    mesh.faces.clear();
    mesh.boundaries.clear();
    for (std::size_t h = 0; h < twin_.size(); ++h)
      mesh.newHalfedge();
    fill_vertices(mesh);
    fill_faces(mesh);
    for (Id h = 0; h < twin_.size(); ++h) {
      Halfedge* record = mesh.halfedges.at(h);
      record->next() = halfedge(mesh, next_[h]);
      record->twin() = halfedge(mesh, twin_[h]);
      record->vertex() = VertexIter(mesh.vertices.at(start_of(h)));
      if (h < twin_[h]) {
        EdgeIter e = mesh.newEdge();
        e->halfedge() = HalfedgeIter(record);
        record->edge() = e;
      } else {
        record->edge() = mesh.halfedges.at(twin_[h])->edge();
      }
    }
  }

  static HalfedgeIter halfedge(const HalfedgeMesh& mesh, Id h) {
    return HalfedgeIter(mesh.halfedges.at(h));
  }

  void fill_vertices(HalfedgeMesh& mesh) const {
    for (Id v = 0; v < input_of_.size(); ++v) {
      VertexIter vertex = mesh.newVertex();
      vertex->position = positions_[input_of_[v]];
      const Id outside = boundary_leaving_[v];
      vertex->halfedge() = halfedge(mesh, outside != kNone ? outside : first_leaving_[v]);
    }
  }

  void fill_faces(HalfedgeMesh& mesh) const {
    for (Id h = 0; h < twin_.size(); ++h) {
      const bool inside = h < origin_.size();
      Halfedge* first = mesh.halfedges.at(h);
      if (first->face() != FaceIter()) continue;
      FaceIter face = inside ? mesh.newFace() : mesh.newBoundary();
      face->halfedge() = HalfedgeIter(first);
      Id g = h;
      do {
        mesh.halfedges.at(g)->face() = face;
        g = next_[g];
      } while (g != h);
    }
  }

  const std::vector<std::vector<Index>>& polygons_;
  const std::vector<Vector3D>& positions_;
  std::vector<Id> number_of_;         // input vertex -> number
  std::vector<Id> input_of_;          // number -> input vertex
  std::vector<Id> origin_;            // corner -> number of its vertex
  std::vector<Id> polygon_;           // corner -> polygon
  std::vector<Id> next_;              // half-edge -> half-edge; boundary ones after the corners
  std::vector<Id> twin_;              // half-edge -> half-edge
  std::vector<Id> boundary_leaving_;  // vertex -> its boundary half-edge, or none
  std::vector<Id> first_leaving_;     // vertex -> the first half-edge that leaves it
};

}  // namespace detail
}  // namespace meshedit
