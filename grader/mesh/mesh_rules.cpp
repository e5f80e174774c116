#include "grader/mesh/mesh_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace meshgrade {
namespace {

constexpr std::size_t kMostBreaksPerRule = 8;

std::string times(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// The same for a, b and b, a.
std::uint64_t pair_key(Ref a, Ref b) {
  return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

struct HashOfCorners {
  std::size_t operator()(const std::array<Ref, 3>& corners) const {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>((pair_key(corners[0], corners[1]) * kOdd + corners[2]) *
                                    kOdd);
  }
};

class RuleChecker {
 public:
  RuleChecker(const MeshDump& mesh, FaceShape shape)
      : mesh_(mesh), shape_(shape), n_(static_cast<Ref>(mesh.halfedges.size())) {}

  std::vector<RuleBreak> check() {
    check_live_pointers();
    check_twins();
    check_next();
    check_face_loops();
    check_anchors();
    check_fans();
    check_boundary();
    check_simple();
    check_finite();
    return std::move(breaks_);
  }

 private:
  bool live_halfedge(Ref h) const { return h < n_ && mesh_.halfedges[h].live != 0; }
  bool live_vertex(Ref v) const {
    return v < mesh_.vertices.size() && mesh_.vertices[v].live != 0;
  }
  bool live_edge(Ref e) const { return e < mesh_.edges.size() && mesh_.edges[e].live != 0; }
  bool live_face(Ref f) const {
    const FaceRecord* record = find_face(mesh_, f);
    return record != nullptr && record->live != 0;
  }
  const HalfedgeRecord& at(Ref h) const { return mesh_.halfedges[h]; }

  void report(const char* rule, std::string element, std::string expected, std::string actual,
              std::string look_at) {
    if (rule != rule_) {
      rule_ = rule;
      count_ = 0;
    }
    if (count_++ >= kMostBreaksPerRule) return;
    breaks_.push_back(
        {rule, std::move(element), std::move(expected), std::move(actual), std::move(look_at)});
  }

  template <class Visit>
  void for_each_halfedge(Visit visit) {
    for (Ref h = 0; h < n_; ++h) {
      if (at(h).live != 0) visit(h, at(h));
    }
  }

  void report_dead(const std::string& pointer, const char* kind, const std::string& target) {
    report("live-pointer", pointer.substr(0, pointer.find('.')),
           pointer + " leads to a " + kind + " of this mesh",
           target == "unset" ? pointer + " was never set" : pointer + " leads to: " + target,
           pointer);
  }

  template <class Records, class NameOf>
  void require_live_anchors(const Records& records, NameOf name_of) {
    for (Ref i = 0; i < records.size(); ++i) {
      if (records[i].live == 0 || live_halfedge(records[i].halfedge)) continue;
      report_dead(name_of(i) + ".halfedge", "half-edge", halfedge_name(records[i].halfedge));
    }
  }

  void check_live_pointers() {
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      // Names only where there is something to say: large meshes have many half-edges.
      const auto pointer = [h](const char* member) { return halfedge_name(h) + member; };
      if (!live_halfedge(r.next))
        report_dead(pointer(".next"), "half-edge", halfedge_name(r.next));
      if (!live_halfedge(r.twin))
        report_dead(pointer(".twin"), "half-edge", halfedge_name(r.twin));
      if (!live_vertex(r.vertex))
        report_dead(pointer(".vertex"), "vertex", vertex_name(r.vertex));
      if (!live_edge(r.edge)) report_dead(pointer(".edge"), "edge", edge_name(r.edge));
      if (!live_face(r.face)) report_dead(pointer(".face"), "face", face_name(r.face));
    });
    require_live_anchors(mesh_.vertices, vertex_name);
    require_live_anchors(mesh_.edges, edge_name);
    require_live_anchors(mesh_.faces, face_name);
    require_live_anchors(mesh_.boundaries, [](Ref b) { return face_name(b | kBoundaryBit); });
  }

  void check_twins() {
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.twin) || (r.twin != h && at(r.twin).twin == h)) return;
      const std::string name = halfedge_name(h);
      if (r.twin == h) {
        report("twin-involution", name, name + ".twin is another half-edge",
               name + ".twin is " + name + " itself", name + ".twin");
      } else {
        report("twin-involution", name,
               name + ".twin is " + halfedge_name(r.twin) + ", so " + halfedge_name(r.twin) +
                   ".twin is " + name,
               halfedge_name(r.twin) + ".twin is " + halfedge_name(at(r.twin).twin),
               name + ".twin and " + halfedge_name(r.twin) + ".twin");
      }
    });
    check_twin_edges();
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.twin) || !live_halfedge(r.next)) return;
      const Ref end = at(r.next).vertex;
      const Ref start_of_twin = at(r.twin).vertex;
      if (end == start_of_twin) return;
      report("twin-opposite", halfedge_name(h),
             "the twin of " + halfedge_name(h) + " (" + halfedge_name(r.twin) +
                 ") starts where " + halfedge_name(h) + " ends, at " + vertex_name(end),
             halfedge_name(r.twin) + " starts at " + vertex_name(start_of_twin),
             halfedge_name(r.twin) + ".vertex, " + halfedge_name(h) + ".next and " +
                 halfedge_name(r.next) + ".vertex");
    });
  }

  void check_twin_edges() {
    std::vector<std::size_t> sides(mesh_.edges.size(), 0);
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (live_edge(r.edge)) ++sides[r.edge];
      if (!live_halfedge(r.twin) || at(r.twin).edge == r.edge || r.twin < h) return;
      report("twin-edge", halfedge_name(h),
             halfedge_name(h) + " and its twin " + halfedge_name(r.twin) + " share one edge",
             halfedge_name(h) + ".edge is " + edge_name(r.edge) + ", " + halfedge_name(r.twin) +
                 ".edge is " + edge_name(at(r.twin).edge),
             halfedge_name(h) + ".edge and " + halfedge_name(r.twin) + ".edge");
    });
    for (Ref e = 0; e < sides.size(); ++e) {
      if (mesh_.edges[e].live == 0 || sides[e] == 2) continue;
      report("twin-edge", edge_name(e),
             "two half-edges name " + edge_name(e) + " as their edge",
             times(sides[e], "half-edge") + (sides[e] == 1 ? " does" : " do"),
             "the .edge of the half-edges around " + edge_name(e));
    }
  }

  void check_next() {
    std::vector<Ref> before(n_, kUnsetRef);
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.next)) return;
      if (before[r.next] != kUnsetRef) {
        report("next-permutation", halfedge_name(r.next),
               "one half-edge has " + halfedge_name(r.next) + " as its next",
               "both " + halfedge_name(before[r.next]) + " and " + halfedge_name(h) + " do",
               halfedge_name(before[r.next]) + ".next and " + halfedge_name(h) + ".next");
      }
      before[r.next] = h;
    });
    for_each_halfedge([&](Ref h, const HalfedgeRecord& /*r*/) {
      if (before[h] != kUnsetRef) return;
      report("next-permutation", halfedge_name(h),
             "one half-edge has " + halfedge_name(h) + " as its next", "none does",
             "the .next of the half-edge that ends where " + halfedge_name(h) + " starts");
    });
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.next) || at(r.next).face == r.face) return;
      report("next-face", halfedge_name(h),
             halfedge_name(h) + " and its next " + halfedge_name(r.next) + " share one face",
             halfedge_name(h) + ".face is " + face_name(r.face) + ", " + halfedge_name(r.next) +
                 ".face is " + face_name(at(r.next).face),
             halfedge_name(h) + ".face, " + halfedge_name(r.next) + ".face and " +
                 halfedge_name(h) + ".next");
    });
  }

  /// Half-edges that name each face, indexed like faces, boundary loops after them.
  std::vector<std::size_t> count_sides() {
    std::vector<std::size_t> sides(mesh_.faces.size() + mesh_.boundaries.size(), 0);
    for_each_halfedge([&](Ref, const HalfedgeRecord& r) {
      if (live_face(r.face)) ++sides[face_index(r.face)];
    });
    return sides;
  }
  std::size_t face_index(Ref f) const {
    return (f & kBoundaryBit) != 0 ? mesh_.faces.size() + (f & ~kBoundaryBit) : f;
  }

  void check_face_loops() {
    const std::vector<std::size_t> sides = count_sides();
    const auto check_loop = [&](Ref f, const FaceRecord& record) {
      if (record.live == 0 || !live_halfedge(record.halfedge)) return;
      // A limit by the face's own size keeps all walks together linear.
      const std::size_t named = sides[face_index(f)];
      const std::size_t limit = named + 64;
      std::size_t walked = 0;
      Ref h = record.halfedge;
      do {
        ++walked;
        h = at(h).next;
      } while (live_halfedge(h) && h != record.halfedge && walked <= limit);
      if (h != record.halfedge) {
        const std::string name = face_name(f);
        report("face-loop", name,
               "walking next from " + name + ".halfedge (" + halfedge_name(record.halfedge) +
                   ") comes back to it",
               walked > limit ? "it does not, after " + times(walked, "step")
                              : "it leads to no half-edge",
               name + ".halfedge, and the .next around " + name);
      } else if (walked != named || !is_degree_right(f, named)) {
        report_loop(f, record.halfedge, walked, named);
      }
    };
    for (Ref f = 0; f < mesh_.faces.size(); ++f)
      check_loop(f, mesh_.faces[f]);
    for (Ref b = 0; b < mesh_.boundaries.size(); ++b) {
      check_loop(b | kBoundaryBit, mesh_.boundaries[b]);
    }
  }

  bool is_degenerate_allowed() const { return shape_ == FaceShape::kDegeneratePolygons; }

  bool is_degree_right(Ref f, std::size_t degree) const {
    if (shape_ != FaceShape::kTriangles) return degree >= 3;
    return degree == 3 || (f & kBoundaryBit) != 0;
  }

  void report_loop(Ref f, Ref start, std::size_t walked, std::size_t named) {
    const std::string name = face_name(f);
    const char* what = (f & kBoundaryBit) != 0           ? "every half-edge of the loop"
                       : shape_ == FaceShape::kTriangles ? "the 3 half-edges of a triangle"
                                                         : "every half-edge of the face, 3 at "
                                                           "least";
    report("face-loop", name, "walking next from " + name + ".halfedge meets " + what,
           "the walk from " + halfedge_name(start) + " meets " + times(walked, "half-edge") +
               ", and " + times(named, "half-edge") + (named == 1 ? " names " : " name ") +
               name + " as face",
           "the .next and the .face of the half-edges around " + name);
  }

  void check_anchors() {
    for (Ref v = 0; v < mesh_.vertices.size(); ++v) {
      const VertexRecord& r = mesh_.vertices[v];
      if (r.live == 0 || !live_halfedge(r.halfedge) || at(r.halfedge).vertex == v) continue;
      report("anchor", vertex_name(v), vertex_name(v) + ".halfedge starts at " + vertex_name(v),
             vertex_name(v) + ".halfedge is " + halfedge_name(r.halfedge) +
                 ", which starts at " + vertex_name(at(r.halfedge).vertex),
             vertex_name(v) + ".halfedge");
    }
    for (Ref e = 0; e < mesh_.edges.size(); ++e) {
      const EdgeRecord& r = mesh_.edges[e];
      if (r.live == 0 || !live_halfedge(r.halfedge) || at(r.halfedge).edge == e) continue;
      report("anchor", edge_name(e), edge_name(e) + ".halfedge lies on " + edge_name(e),
             edge_name(e) + ".halfedge is " + halfedge_name(r.halfedge) + ", which lies on " +
                 edge_name(at(r.halfedge).edge),
             edge_name(e) + ".halfedge");
    }
    const auto check_face = [&](Ref f, const FaceRecord& r) {
      if (r.live == 0 || !live_halfedge(r.halfedge) || at(r.halfedge).face == f) return;
      report("anchor", face_name(f), face_name(f) + ".halfedge lies in " + face_name(f),
             face_name(f) + ".halfedge is " + halfedge_name(r.halfedge) + ", which lies in " +
                 face_name(at(r.halfedge).face),
             face_name(f) + ".halfedge");
    };
    for (Ref f = 0; f < mesh_.faces.size(); ++f)
      check_face(f, mesh_.faces[f]);
    for (Ref b = 0; b < mesh_.boundaries.size(); ++b) {
      check_face(b | kBoundaryBit, mesh_.boundaries[b]);
    }
  }

  void check_fans() {
    std::vector<std::size_t> leaving(mesh_.vertices.size(), 0);
    for_each_halfedge([&](Ref, const HalfedgeRecord& r) {
      if (live_vertex(r.vertex)) ++leaving[r.vertex];
    });
    for (Ref v = 0; v < mesh_.vertices.size(); ++v) {
      const VertexRecord& r = mesh_.vertices[v];
      if (r.live == 0 || !live_halfedge(r.halfedge)) continue;
      std::size_t walked = 0;
      Ref h = r.halfedge;
      do {
        ++walked;
        h = live_halfedge(at(h).twin) ? at(at(h).twin).next : kUnsetRef;
      } while (live_halfedge(h) && h != r.halfedge && walked <= leaving[v]);
      if (h == r.halfedge && walked == leaving[v]) continue;
      report("vertex-fan", vertex_name(v),
             "walking twin, next around " + vertex_name(v) + " meets the " +
                 times(leaving[v], "half-edge") + " that start there",
             h == r.halfedge ? "the walk meets " + times(walked, "half-edge")
                             : "the walk does not come back to " + halfedge_name(r.halfedge),
             "the .twin and .next of the half-edges around " + vertex_name(v) +
                 ", and which of them name " + vertex_name(v) + " as .vertex");
    }
  }

  void check_boundary() {
    const auto check_flag = [&](Ref f, const FaceRecord& r, bool outside) {
      if (r.live == 0 || (r.is_boundary != 0) == outside) return;
      report("boundary", face_name(f), outside ? "a boundary loop" : "no boundary loop",
             outside ? "its isBoundary() is false" : "its isBoundary() is true", face_name(f));
    };
    for (Ref f = 0; f < mesh_.faces.size(); ++f)
      check_flag(f, mesh_.faces[f], false);
    for (Ref b = 0; b < mesh_.boundaries.size(); ++b) {
      check_flag(b | kBoundaryBit, mesh_.boundaries[b], true);
    }
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.twin) || r.twin < h || !is_plain(r.face)) return;
      const Ref across = at(r.twin).face;
      if (!is_plain(across) || (r.face & across & kBoundaryBit) == 0) return;
      report("boundary", edge_name(r.edge), "a face of the surface on one side at least",
             "boundary loops on both sides",
             halfedge_name(h) + ".face and " + halfedge_name(r.twin) + ".face");
    });
  }

  void check_simple() {
    std::unordered_map<std::uint64_t, Ref> edge_between;
    edge_between.reserve(n_ / 2U);
    for_each_halfedge([&](Ref h, const HalfedgeRecord& r) {
      if (!live_halfedge(r.twin) || r.twin < h) return;
      const Ref a = r.vertex;
      const Ref b = at(r.twin).vertex;
      if (a == b) {
        report("simple", edge_name(r.edge), "an edge joins two different vertices",
               edge_name(r.edge) + " joins " + vertex_name(a) + " to itself",
               halfedge_name(h) + ".vertex and " + halfedge_name(r.twin) + ".vertex");
        return;
      }
      const auto [place, is_new] = edge_between.try_emplace(pair_key(a, b), r.edge);
      if (is_new || place->second == r.edge || is_degenerate_allowed()) return;
      report("simple", edge_name(r.edge), "one edge at most between two vertices",
             edge_name(place->second) + " and " + edge_name(r.edge) + " both join " +
                 vertex_name(a) + " and " + vertex_name(b),
             "which edges were to be flipped or split");
    });
    if (shape_ == FaceShape::kTriangles) {
      check_same_corners();
    } else {
      check_polygons();
    }
  }

  /// The corners of a face in ascending order; none where the walk does not come back.
  std::vector<Ref> sorted_corners(const FaceRecord& face) const {
    std::vector<Ref> corners;
    Ref h = face.halfedge;
    do {
      if (!live_halfedge(h) || corners.size() > n_) return {};
      corners.push_back(at(h).vertex);
      h = at(h).next;
    } while (h != face.halfedge);
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void check_polygons() {
    std::map<std::vector<Ref>, Ref> face_with;
    for (Ref f = 0; f < mesh_.faces.size(); ++f) {
      if (mesh_.faces[f].live == 0) continue;
      const std::vector<Ref> corners = sorted_corners(mesh_.faces[f]);
      if (corners.empty()) continue;
      const auto twice = std::adjacent_find(corners.begin(), corners.end());
      const auto [place, is_new] = face_with.try_emplace(corners, f);
      const std::string look_at = "the .vertex of the half-edges around " + face_name(f);
      if (twice != corners.end()) {
        report("simple", face_name(f), "a face visits each of its corners once",
               face_name(f) + " visits " + vertex_name(*twice) + " more than once", look_at);
      } else if (!is_new && !is_degenerate_allowed()) {
        report("simple", face_name(f), "no two faces with the same corners",
               face_name(place->second) + " and " + face_name(f) + " have the same corners",
               look_at);
      }
    }
  }

  void check_same_corners() {
    std::unordered_map<std::array<Ref, 3>, Ref, HashOfCorners> face_with;
    face_with.reserve(mesh_.faces.size());
    for (Ref f = 0; f < mesh_.faces.size(); ++f) {
      const FaceRecord& r = mesh_.faces[f];
      if (r.live == 0 || !live_halfedge(r.halfedge)) continue;
      const Ref second = at(r.halfedge).next;
      if (!live_halfedge(second) || !live_halfedge(at(second).next)) continue;
      std::array<Ref, 3> corners{at(r.halfedge).vertex, at(second).vertex,
                                 at(at(second).next).vertex};
      std::sort(corners.begin(), corners.end());
      const auto [place, is_new] = face_with.try_emplace(corners, f);
      if (is_new) continue;
      report("simple", face_name(f), "no two faces with the same corners",
             face_name(place->second) + " and " + face_name(f) + " have the corners " +
                 vertex_name(corners[0]) + ", " + vertex_name(corners[1]) + ", " +
                 vertex_name(corners[2]),
             "the .vertex of the half-edges around " + face_name(f));
    }
  }

  void check_finite() {
    for (Ref v = 0; v < mesh_.vertices.size(); ++v) {
      const VertexRecord& r = mesh_.vertices[v];
      const bool finite = std::all_of(r.position.begin(), r.position.end(),
                                      [](double x) { return std::isfinite(x); });
      if (r.live == 0 || finite) continue;
      report("finite", vertex_name(v), "three finite numbers as position",
             "a coordinate that is not a number or infinite", vertex_name(v) + ".position");
    }
  }

  const MeshDump& mesh_;
  const FaceShape shape_;
  const Ref n_;
  std::vector<RuleBreak> breaks_;
  std::string rule_;
  std::size_t count_ = 0;
};

}  // namespace

const std::vector<Rule>& mesh_rules() {
  static const std::vector<Rule> rules{
      {"live-pointer",
       "every pointer leads to an element of this mesh that was not deleted, of the right "
       "kind"},
      {"twin-involution",
       "the twin of the twin of a half-edge is the half-edge itself, and no half-edge is its "
       "own "
       "twin"},
      {"twin-edge",
       "a half-edge and its twin share their edge, and each edge has exactly these two"},
      {"twin-opposite", "the twin of a half-edge starts where the half-edge ends"},
      {"next-permutation", "every half-edge is the next of exactly one half-edge"},
      {"next-face", "a half-edge and its next lie in the same face"},
      {"face-loop",
       "walking next from the half-edge of a face meets exactly the half-edges of that face, "
       "and "
       "three of them unless it is a boundary loop"},
      {"anchor",
       "the half-edge of a vertex starts there, that of an edge lies on it, that of a face "
       "lies "
       "in it"},
      {"vertex-fan",
       "walking twin, next around a vertex meets every half-edge that starts there"},
      {"boundary",
       "boundary loops, and only they, are marked as boundary; none is lost, none "
       "appears"},
      {"simple",
       "no edge joins a vertex to itself, no two edges join the same two vertices, no face "
       "visits a vertex twice, no two faces have the same corners"},
      {"counts",
       "the numbers of vertices, edges, faces and half-edges are what the operation makes "
       "them"},
      {"orientation", "the surface keeps its winding: no face is turned inside out"},
      {"finite", "every coordinate is a finite number"},
  };
  return rules;
}

std::string_view rule_meaning(std::string_view name) {
  for (const Rule& rule : mesh_rules()) {
    if (rule.name == name) return rule.meaning;
  }
  return {};
}

std::vector<RuleBreak> find_broken_rules(const MeshDump& mesh, FaceShape shape) {
  return RuleChecker(mesh, shape).check();
}

}  // namespace meshgrade
