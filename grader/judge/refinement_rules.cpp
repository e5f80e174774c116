#include "grader/judge/refinement_rules.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <utility>

namespace meshgrade {
namespace {

using Weighted = std::pair<double, Point3>;

Point3 sum_of(std::initializer_list<Weighted> terms) {
  Point3 sum{};
  for (const auto& [weight, point] : terms) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum[axis] += weight * point[axis];
  }
  return sum;
}

Point3 sum_at(const std::vector<Point3>& points, const std::vector<Ref>& which) {
  Point3 sum{};
  for (const Ref i : which)
    sum = sum_of({{1.0, sum}, {1.0, points[i]}});
  return sum;
}

Point3 scaled_by(double factor, const Point3& point) {
  return sum_of({{factor, point}});
}

double size_of(const std::vector<Ref>& list) {
  return static_cast<double>(list.size());
}

Point3 mean_at(const std::vector<Point3>& points, const std::vector<Ref>& which) {
  return scaled_by(1.0 / size_of(which), sum_at(points, which));
}

/// Computes one point of a kind, by the number of its element.
using PointRule = std::function<Point3(Ref)>;

/// The rules of Catmull and Clark and, as members, what they are made of.
class Terms {
 public:
  Terms(const SurfaceRings& rings, const RefinedPoints& given) : rings_(rings), given_(given) {}

  const SurfaceRings::OfVertex& at(Ref v) const { return rings_.vertices[v]; }
  const SurfaceRings::OfEdge& edge(Ref e) const { return rings_.edges[e]; }
  const std::vector<Ref>& corners(Ref f) const { return rings_.corners[f]; }
  const std::vector<Point3>& positions() const { return rings_.positions; }

  Point3 middle(Ref e) const { return scaled_by(0.5, ends(e)); }
  Point3 ends(Ref e) const {
    return sum_of({{1.0, rings_.positions[edge(e).a]}, {1.0, rings_.positions[edge(e).b]}});
  }
  Point3 beside(Ref e) const { return sum_at(given_.faces, edge(e).faces); }
  /// The mean of the corners of a boundary loop, as if it were a face.
  Point3 outside(Ref e) const { return mean_at(rings_.positions, edge(e).loop); }

  double n(Ref v) const { return size_of(at(v).edges); }
  Point3 own(Ref v) const { return rings_.positions[v]; }
  Point3 face_sum(Ref v) const { return sum_at(given_.faces, at(v).faces); }
  Point3 edge_point_sum(Ref v) const { return sum_at(given_.edges, at(v).edges); }
  Point3 middle_sum(Ref v) const {
    Point3 sum{};
    for (const Ref e : at(v).edges)
      sum = sum_of({{1.0, sum}, {1.0, middle(e)}});
    return sum;
  }
  Point3 neighbour_sum(Ref v) const { return sum_of({{2.0, middle_sum(v)}, {-n(v), own(v)}}); }
  Point3 q(Ref v) const { return scaled_by(1.0 / size_of(at(v).faces), face_sum(v)); }
  Point3 r(Ref v) const { return scaled_by(1.0 / n(v), middle_sum(v)); }

  /// (Q + 2 R + (n - 3) S) / n
  Point3 inner(Ref v, const Point3& q, const Point3& r) const { return inner(v, q, r, n(v)); }
  Point3 inner(Ref v, const Point3& q, const Point3& r, double n) const {
    return sum_of({{1.0 / n, q}, {2.0 / n, r}, {(n - 3.0) / n, own(v)}});
  }

  /// The sum of something of the two edges along the boundary.
  Point3 along(Ref v, const PointRule& of_edge) const {
    Point3 sum{};
    for (const Ref e : at(v).edges) {
      if (edge(e).is_boundary()) sum = sum_of({{1.0, sum}, {1.0, of_edge(e)}});
    }
    return sum;
  }
  Point3 neighbours_along(Ref v) const {
    return along(v, [&](Ref e) { return own(edge(e).other(v)); });
  }
  Point3 neighbours_on_boundary(Ref v) const {
    Point3 sum{};
    for (const Ref e : at(v).edges) {
      const Ref w = edge(e).other(v);
      if (at(w).is_boundary()) sum = sum_of({{1.0, sum}, {1.0, own(w)}});
    }
    return sum;
  }
  Point3 given_edge(Ref e) const { return given_.edges[e]; }
  Point3 given_face(Ref f) const { return given_.faces[f]; }

  Point3 face_rule(Ref f) const { return mean_at(rings_.positions, corners(f)); }
  Point3 edge_rule(Ref e) const {
    if (edge(e).is_boundary()) return middle(e);
    return sum_of({{0.25, ends(e)}, {0.25, beside(e)}});
  }
  Point3 vertex_rule(Ref v) const {
    if (!at(v).is_boundary()) return inner(v, q(v), r(v));
    return sum_of({{0.75, own(v)}, {0.125, neighbours_along(v)}});
  }

 private:
  const SurfaceRings& rings_;
  const RefinedPoints& given_;
};

class Predictor {
 public:
  Predictor(const SurfaceRings& rings, const RefinedPoints& given)
      : rings_(rings), t_(rings, given) {}

  std::vector<Prediction<Point3>> take() { return std::move(predictions_); }

  void faces() {
    const auto n = [this](Ref f) { return size_of(t_.corners(f)); };
    const auto sum = [this](Ref f) { return sum_at(t_.positions(), t_.corners(f)); };
    const auto rest = [this, sum](Ref f) {
      return sum_of({{1.0, sum(f)}, {-1.0, t_.own(t_.corners(f)[0])}});
    };
    face("face-zero", [](Ref) { return Point3{}; });
    face("face-sum", sum);
    for (const double number : {3.0, 4.0})
      face("face-fixed-number", [=](Ref f) { return scaled_by(1.0 / number, sum(f)); });
    face("face-corner-left-out", [=](Ref f) { return scaled_by(1.0 / n(f), rest(f)); });
    face("face-corner-left-out", [=](Ref f) { return scaled_by(1.0 / (n(f) - 1.0), rest(f)); });
  }

  void edges(RefinementScheme scheme) {
    edge("edge-zero", [](Ref) { return Point3{}; });
    if (scheme == RefinementScheme::kLinear) {
      edge("edge-sum", [this](Ref e) { return t_.ends(e); });
      edge("edge-at-an-end", [this](Ref e) { return t_.own(t_.edge(e).a); });
      edge("edge-at-an-end", [this](Ref e) { return t_.own(t_.edge(e).b); });
      edge("smoothed", [this](Ref e) { return t_.edge_rule(e); });
    } else {
      inner_edges();
      boundary_edges();
    }
  }

  void vertices(RefinementScheme scheme) {
    vertex("vertex-zero", [](Ref) { return Point3{}; });
    if (scheme == RefinementScheme::kLinear) {
      vertex("smoothed", [this](Ref v) { return t_.vertex_rule(v); });
    } else {
      if (has_inner_vertex()) vertex("vertex-kept", [this](Ref v) { return t_.own(v); });
      inner_terms();
      inner_weights();
      boundary_vertices();
      boundary_like_inside();
    }
  }

 private:
  void inner_edges() {
    inner_edge("edge-zero", [](Ref) { return Point3{}; });
    edge("edge-midpoints", [this](Ref e) { return t_.middle(e); });
    inner_edge("edge-not-divided", [this](Ref e) {
      return sum_of({{1.0, t_.ends(e)}, {1.0, t_.beside(e)}});
    });
    inner_edge("edge-middle-and-faces", [this](Ref e) {
      return sum_of({{1.0 / 3.0, t_.middle(e)}, {1.0 / 3.0, t_.beside(e)}});
    });
    for (const std::size_t side : {0U, 1U}) {
      inner_edge("edge-same-face-twice", [this, side](Ref e) {
        const Point3 beside = t_.given_face(t_.edge(e).faces[side]);
        return sum_of({{0.25, t_.ends(e)}, {0.5, beside}});
      });
    }
  }

  void boundary_edges() {
    boundary_edge("edge-sum", [this](Ref e) { return t_.ends(e); });
    boundary_edge("edge-boundary-like-inside", [this](Ref e) {
      return sum_of({{1.0 / 3.0, t_.ends(e)}, {1.0 / 3.0, t_.beside(e)}});
    });
    boundary_edge("edge-boundary-like-inside", [this](Ref e) {
      return sum_of({{0.25, t_.ends(e)}, {0.25, t_.beside(e)}});
    });
    boundary_edge("edge-boundary-like-inside", [this](Ref e) {
      return sum_of({{0.25, t_.ends(e)}, {0.25, t_.beside(e)}, {0.25, t_.outside(e)}});
    });
  }

  void inner_terms() {
    inner_vertex("r-from-edge-points", [this](Ref v) {
      return t_.inner(v, t_.q(v), scaled_by(1.0 / t_.n(v), t_.edge_point_sum(v)));
    });
    inner_vertex("r-from-neighbours", [this](Ref v) {
      return t_.inner(v, t_.q(v), scaled_by(1.0 / t_.n(v), t_.neighbour_sum(v)));
    });
    inner_vertex("q-from-the-vertex",
                 [this](Ref v) { return t_.inner(v, t_.own(v), t_.r(v)); });
    inner_vertex("sums-for-means",
                 [this](Ref v) { return t_.inner(v, t_.face_sum(v), t_.r(v)); });
    inner_vertex("sums-for-means",
                 [this](Ref v) { return t_.inner(v, t_.q(v), t_.middle_sum(v)); });
    inner_vertex("sums-for-means",
                 [this](Ref v) { return t_.inner(v, t_.face_sum(v), t_.middle_sum(v)); });
  }

  void inner_weights() {
    inner_vertex("own-weight-zero", [this](Ref v) {
      const double n = t_.n(v);
      return sum_of({{1.0 / n, t_.q(v)}, {2.0 / n, t_.r(v)}});
    });
    inner_vertex("r-weight-zero", [this](Ref v) {
      const double n = t_.n(v);
      return sum_of({{1.0 / n, t_.q(v)}, {(n - 3.0) / n, t_.own(v)}});
    });
    inner_vertex("not-divided-by-n", [this](Ref v) {
      return sum_of({{1.0, t_.q(v)}, {2.0, t_.r(v)}, {t_.n(v) - 3.0, t_.own(v)}});
    });
    inner_vertex("four-for-n", [this](Ref v) { return t_.inner(v, t_.q(v), t_.r(v), 4.0); });
    inner_vertex("four-for-n", [this](Ref v) {
      return scaled_by(t_.n(v) / 4.0, t_.inner(v, t_.q(v), t_.r(v)));
    });
  }

  void boundary_vertices() {
    boundary_vertex("boundary-vertex-kept", [this](Ref v) { return t_.own(v); });
    boundary_weights("boundary-quarter", 0.75, 0.25);
    boundary_weights("boundary-quarter", 0.5, 0.25);
    boundary_weights("boundary-whole-numbers", 0.0, 0.125);
    boundary_weights("boundary-whole-numbers", 0.75, 0.0);
    boundary_weights("boundary-whole-numbers", 0.0, 0.0);
    boundary_vertex("boundary-vertices-counted", [this](Ref v) {
      return sum_of({{0.75, t_.own(v)}, {0.125, t_.neighbours_on_boundary(v)}});
    });
    boundary_vertex("boundary-edge-points", [this](Ref v) {
      const Point3 points = t_.along(v, [this](Ref e) { return t_.given_edge(e); });
      return sum_of({{0.75, t_.own(v)}, {0.125, points}});
    });
  }

  /// The number of edges, or that of faces, as degree() has it; and the boundary loop left out,
  /// as a face without a point, or as one with.
  void boundary_like_inside() {
    const char* name = "boundary-like-inside";
    const auto faces = [this](Ref v) { return size_of(t_.at(v).faces); };
    const auto part = [this](Ref v, double n) { return scaled_by(1.0 / n, t_.face_sum(v)); };
    const auto middles = [this](Ref v, double n) {
      return scaled_by(1.0 / n, t_.middle_sum(v));
    };
    boundary_vertex(name, [=, this](Ref v) { return t_.inner(v, t_.q(v), t_.r(v)); });
    boundary_vertex(name, [=, this](Ref v) { return t_.inner(v, part(v, t_.n(v)), t_.r(v)); });
    boundary_vertex(name, [=, this](Ref v) { return t_.inner(v, t_.q(v), t_.r(v), faces(v)); });
    boundary_vertex(name, [=, this](Ref v) {
      return t_.inner(v, t_.q(v), middles(v, faces(v)), faces(v));
    });
    boundary_vertex(name, [=, this](Ref v) {
      const Point3 loop = scaled_by(0.5, t_.along(v, [this](Ref e) { return t_.outside(e); }));
      const Point3 q = sum_of({{1.0 / t_.n(v), t_.face_sum(v)}, {1.0 / t_.n(v), loop}});
      return t_.inner(v, q, t_.r(v));
    });
  }

  /// Where there is none, that all vertices are kept says only that those of the boundary are.
  bool has_inner_vertex() const {
    return std::any_of(rings_.vertices.begin(), rings_.vertices.end(),
                       [](const SurfaceRings::OfVertex& v) { return !v.is_boundary(); });
  }

  void add(const char* name, std::size_t n, const PointRule& rule) {
    Prediction<Point3> prediction{name, {}};
    for (Ref i = 0; i < n; ++i)
      prediction.points.push_back(rule(i));
    predictions_.push_back(std::move(prediction));
  }
  void face(const char* name, const PointRule& rule) { add(name, rings_.corners.size(), rule); }
  void edge(const char* name, const PointRule& rule) { add(name, rings_.edges.size(), rule); }
  void vertex(const char* name, const PointRule& rule) {
    add(name, rings_.vertices.size(), rule);
  }
  void inner_edge(const char* name, const PointRule& rule) {
    edge(name, [&](Ref e) { return t_.edge(e).is_boundary() ? t_.edge_rule(e) : rule(e); });
  }
  void boundary_edge(const char* name, const PointRule& rule) {
    edge(name, [&](Ref e) { return t_.edge(e).is_boundary() ? rule(e) : t_.edge_rule(e); });
  }
  void inner_vertex(const char* name, const PointRule& rule) {
    vertex(name, [&](Ref v) { return t_.at(v).is_boundary() ? t_.vertex_rule(v) : rule(v); });
  }
  void boundary_vertex(const char* name, const PointRule& rule) {
    vertex(name, [&](Ref v) { return t_.at(v).is_boundary() ? rule(v) : t_.vertex_rule(v); });
  }
  void boundary_weights(const char* name, double own, double neighbour) {
    boundary_vertex(name, [=, this](Ref v) {
      return sum_of({{own, t_.own(v)}, {neighbour, t_.neighbours_along(v)}});
    });
  }

  const SurfaceRings& rings_;
  Terms t_;
  std::vector<Prediction<Point3>> predictions_;
};

Misconceptions face_and_edge_misconceptions() {
  return {
      {"face-zero",
       "all face points are (0, 0, 0): 1 / n of whole numbers is 0 (write 1.0 / n), or the sum "
       "is never put into the map"},
      {"face-sum", "the sum of the corners is not divided by their number"},
      {"face-fixed-number",
       "the sum of the corners is divided by the same number for all faces: divide by the "
       "number of corners of the face"},
      {"face-corner-left-out",
       "one corner is left out of the sum, where halfedge() of the face starts: begin with it, "
       "as do ... while does"},
      {"edge-zero",
       "all edge points are (0, 0, 0): 1 / 2 and 1 / 4 of whole numbers are 0 (write 0.5), or "
       "the point is never put into the map"},
      {"edge-sum", "the ends are added and not halved"},
  };
}

Misconceptions linear_misconceptions() {
  Misconceptions all = face_and_edge_misconceptions();
  all.push_back({"edge-at-an-end",
                 "edge points lie at one end of their edge: the other end is "
                 "twin()->vertex()"});
  all.push_back({"vertex-zero",
                 "all old vertices go to (0, 0, 0): their position is never put into the map"});
  all.push_back(
      {"smoothed",
       "these are the points of Catmull-Clark subdivision: linear subdivision smooths "
       "nothing"});
  return all;
}

Misconceptions smooth_edge_misconceptions() {
  return {
      {"edge-midpoints",
       "edge points lie in the middle of their edges, also inside: there the new vertices of "
       "the two faces beside count as much as the two ends"},
      {"edge-not-divided",
       "the two ends and the two face points are added and not divided by 4"},
      {"edge-middle-and-faces",
       "the middle of the edge counts as much as each of the two face points: the mean is of "
       "four points, two ends and two face points"},
      {"edge-same-face-twice",
       "the same face is taken for both sides of an edge: the other one is twin()->face()"},
      {"edge-boundary-like-inside",
       "edges on the boundary are treated like those inside: there the point is the middle of "
       "the edge, whatever face is beside it"},
  };
}

Misconceptions smooth_vertex_misconceptions() {
  return {
      {"vertex-kept", "old vertices stay where they were: they move, too"},
      {"vertex-zero",
       "all old vertices go to (0, 0, 0): a weight such as 1 / n of whole numbers is 0, or the "
       "point is never put into the map"},
      {"r-from-edge-points",
       "R is the mean of the new edge points: it must be that of the middles of the old edges"},
      {"r-from-neighbours",
       "R is the mean of the neighbours: it must be that of the middles of the edges to them"},
      {"q-from-the-vertex",
       "Q is the vertex itself: it must be the mean of the new face points around it"},
      {"sums-for-means", "Q or R is a sum: both are means, divided by their number"},
      {"own-weight-zero",
       "the vertex itself counts for nothing: (n - 3) / n of whole numbers is 0 (make n a "
       "double), or (n - 3) S is left out"},
      {"r-weight-zero",
       "R counts for nothing: 2 / n of whole numbers is 0 (write 2.0 / n), or 2 R is left out"},
      {"not-divided-by-n", "Q + 2 R + (n - 3) S is not divided by n"},
      {"four-for-n",
       "the weights are those of a vertex with four edges everywhere: n is the number of edges "
       "at the vertex"},
  };
}

Misconceptions smooth_boundary_misconceptions() {
  return {
      {"boundary-like-inside",
       "vertices on the boundary are moved like those inside: there it is 3/4 of the vertex "
       "and 1/8 of each of its two neighbours along the boundary"},
      {"boundary-vertex-kept",
       "vertices on the boundary stay where they were: they move to 3/4 of themselves and 1/8 "
       "of each of their two neighbours along the boundary"},
      {"boundary-quarter", "on the boundary each of the two neighbours has 1/8, not 1/4"},
      {"boundary-whole-numbers",
       "on the boundary a weight is divided as whole numbers and becomes 0: write 3.0 / 4.0 "
       "and 1.0 / 8.0"},
      {"boundary-vertices-counted",
       "on the boundary all neighbours that lie on a boundary are counted: only the two along "
       "it are, over edges that lie on it"},
      {"boundary-edge-points",
       "on the boundary new edge points are taken in place of the two neighbours"},
  };
}

}  // namespace

std::vector<Point3> RefinementRules::points(PointKind kind) const {
  const Terms terms(rings_, given_);
  const bool smooth = scheme_ == RefinementScheme::kCatmullClark;
  std::vector<Point3> points;
  if (kind == PointKind::kFace) {
    for (Ref f = 0; f < rings_.corners.size(); ++f)
      points.push_back(terms.face_rule(f));
  } else if (kind == PointKind::kEdge) {
    for (Ref e = 0; e < rings_.edges.size(); ++e)
      points.push_back(smooth ? terms.edge_rule(e) : terms.middle(e));
  } else {
    for (Ref v = 0; v < rings_.vertices.size(); ++v)
      points.push_back(smooth ? terms.vertex_rule(v) : terms.own(v));
  }
  return points;
}

std::vector<Prediction<Point3>> RefinementRules::predictions(PointKind kind) const {
  Predictor predictor(rings_, given_);
  if (kind == PointKind::kFace) {
    predictor.faces();
  } else if (kind == PointKind::kEdge) {
    predictor.edges(scheme_);
  } else {
    predictor.vertices(scheme_);
  }
  return predictor.take();
}

const Misconceptions& refinement_misconceptions(RefinementScheme scheme) {
  static const Misconceptions linear = linear_misconceptions();
  static const Misconceptions smooth = [] {
    Misconceptions all = face_and_edge_misconceptions();
    for (const Misconceptions& more :
         {smooth_edge_misconceptions(), smooth_vertex_misconceptions(),
          smooth_boundary_misconceptions()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return scheme == RefinementScheme::kLinear ? linear : smooth;
}

}  // namespace meshgrade
