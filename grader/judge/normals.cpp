#include "grader/judge/normals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "grader/mesh/point_products.h"

namespace meshgrade {
namespace {

Point3 subtract(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Point3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

void add_scaled(Point3& sum, const Point3& a, double factor) {
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] += factor * a[i];
}

std::vector<Point3> scaled_to_unit(std::vector<Point3> vectors) {
  for (Point3& v : vectors) {
    const double norm = length(v);
    for (double& x : v)
      x /= norm;
  }
  return vectors;
}

/// Of length 1, but for those that have none.
std::vector<Point3> directions_of(std::vector<Point3> vectors) {
  for (Point3& v : vectors) {
    const double norm = length(v);
    if (norm > 0.0 && std::isfinite(norm)) v = scaled_to_unit({v})[0];
  }
  return vectors;
}

double angle(const Point3& a, const Point3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The sum over the faces around each vertex, not scaled. A triangle's cross product has twice
/// its area as length.
std::vector<Point3> weighted_sums(const PolygonMesh& mesh, NormalWeight weight) {
  std::vector<Point3> sums(mesh.positions.size(), Point3{});
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 to_next = subtract(mesh.positions[t[(i + 1) % 3]], mesh.positions[t[i]]);
      const Point3 to_last = subtract(mesh.positions[t[(i + 2) % 3]], mesh.positions[t[i]]);
      const Point3 area = cross(to_next, to_last);
      const double size = length(area);
      double factor = 1.0;
      if (weight == NormalWeight::kEqual) factor = 1.0 / size;
      if (weight == NormalWeight::kAngle) factor = angle(to_next, to_last) / size;
      if (weight == NormalWeight::kAreaSquared) factor = size;
      add_scaled(sums[t[i]], area, factor);
    }
  }
  return sums;
}

/// What of a boundary loop is taken for a face.
enum class LoopPart {
  kTriangle,  ///< the vertex and the next two, like the corners of a face
  kWhole,     ///< the polygon, as Face::normal() does
};

/// For each boundary vertex twice the area of its boundary loop, as a normal; zero for others.
std::vector<Point3> boundary_loop_areas(const PolygonMesh& mesh, LoopPart part) {
  const auto next = boundary_loops(mesh);
  std::vector<Point3> areas(mesh.positions.size(), Point3{});
  for (const auto& [vertex, after] : next) {
    const Point3& origin = mesh.positions[vertex];
    for (std::uint32_t v = after; next.at(v) != vertex; v = next.at(v)) {
      add_scaled(areas[vertex],
                 cross(subtract(mesh.positions[v], origin),
                       subtract(mesh.positions[next.at(v)], origin)),
                 1.0);
      if (part == LoopPart::kTriangle) break;
    }
  }
  return areas;
}

std::vector<Point3> with_boundary_loop(const PolygonMesh& mesh, NormalWeight weight,
                                       LoopPart part) {
  std::vector<Point3> sums = weighted_sums(mesh, weight);
  const std::vector<Point3> loops = boundary_loop_areas(mesh, part);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double size = length(loops[v]);
    if (size > 0.0)
      add_scaled(sums[v], loops[v], weight == NormalWeight::kEqual ? 1.0 / size : 1.0);
  }
  return scaled_to_unit(std::move(sums));
}

std::vector<Point3> multiplied(std::vector<Point3> vectors, double factor) {
  for (Point3& v : vectors)
    v = {factor * v[0], factor * v[1], factor * v[2]};
  return vectors;
}

/// True if every normal that is wrong is explained by one of the faces around its vertex.
/// `explains(area, sum, normal)` gets the face's normal and the sum of all, both weighted.
template <class Explains>
bool some_face_explains(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                        const std::vector<Point3>& actual, double tolerance,
                        Explains explains) {
  const std::vector<Point3> sums = weighted_sums(mesh, NormalWeight::kArea);
  std::vector<bool> explained(actual.size());
  for (std::size_t v = 0; v < actual.size(); ++v) {
    explained[v] = distance(expected[v], actual[v]) <= tolerance;
  }
  for (const auto& t : mesh.polygons) {
    const Point3& p = mesh.positions[t[0]];
    const Point3 area =
        cross(subtract(mesh.positions[t[1]], p), subtract(mesh.positions[t[2]], p));
    for (std::uint32_t v : t) {
      if (v >= actual.size() || explained[v]) continue;
      explained[v] = distance(explains(area, sums[v]), actual[v]) <= tolerance;
    }
  }
  return std::find(explained.begin(), explained.end(), false) == explained.end();
}

using Predictions = std::vector<Prediction<Point3>>;

/// What is added to the sum of a vertex for each of its faces, from the face's three corners,
/// the vertex first.
template <class Summand>
std::vector<Point3> sums_of(const PolygonMesh& mesh, Summand summand) {
  std::vector<Point3> sums(mesh.positions.size(), Point3{});
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      add_scaled(sums[t[i]],
                 summand(mesh.positions[t[i]], mesh.positions[t[(i + 1) % 3]],
                         mesh.positions[t[(i + 2) % 3]]),
                 1.0);
    }
  }
  return sums;
}

/// The cross product of positions in place of edges: as the normal, or only as its length.
void predict_positions_for_edges(const PolygonMesh& mesh, Predictions& predictions) {
  const auto area_of_positions = [](const Point3& /*v*/, const Point3& a, const Point3& b) {
    return cross(a, b);
  };
  predictions.push_back({"positions-for-edges", sums_of(mesh, area_of_positions)});
  const auto weighted = [](const Point3& v, const Point3& a, const Point3& b) {
    const Point3 area = cross(subtract(a, v), subtract(b, v));
    Point3 sum{};
    add_scaled(sum, area, length(cross(a, b)) / length(area));
    return sum;
  };
  predictions.push_back({"positions-for-edges", sums_of(mesh, weighted)});
}

void predict_position_added(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                            Predictions& predictions) {
  for (double factor : {1.0, 0.5}) {  // with twice the areas, and with the areas
    std::vector<Point3> sums = weighted_sums(mesh, NormalWeight::kArea);
    for (std::size_t v = 0; v < sums.size(); ++v) {
      Point3 sum = mesh.positions[v];
      add_scaled(sum, sums[v], factor);
      sums[v] = sum;
    }
    predictions.push_back({"position-added", std::move(sums)});
  }
  std::vector<Point3> moved = expected;
  for (std::size_t v = 0; v < moved.size(); ++v)
    add_scaled(moved[v], mesh.positions[v], 1.0);
  predictions.push_back({"position-added", std::move(moved)});
}

/// Every face with the area of the one that comes before or after it around the vertex. Only
/// for closed meshes: elsewhere nobody knows what comes after the last one.
void predict_neighbours_area(const PolygonMesh& mesh, Predictions& predictions) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point3> faces;  // by (vertex, next corner)
  for (const auto& t : mesh.polygons) {
    const Point3& p = mesh.positions[t[0]];
    const Point3 area =
        cross(subtract(mesh.positions[t[1]], p), subtract(mesh.positions[t[2]], p));
    for (std::size_t i = 0; i < 3; ++i)
      faces[{t[i], t[(i + 1) % 3]}] = area;
  }
  std::vector<Point3> with_next(mesh.positions.size(), Point3{});
  std::vector<Point3> with_last = with_next;
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& area = faces.at({t[i], t[(i + 1) % 3]});
      const Point3& next = faces.at({t[i], t[(i + 2) % 3]});
      add_scaled(with_next[t[i]], area, length(next) / length(area));
      add_scaled(with_last[t[i]], next, length(area) / length(next));
    }
  }
  predictions.push_back({"neighbours-area", std::move(with_next)});
  predictions.push_back({"neighbours-area", std::move(with_last)});
}

/// True if every normal that is wrong is that of a neighbour, or the sum over the faces around
/// a neighbour of what they look like from the vertex itself.
bool some_neighbour_explains(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                             const std::vector<Point3>& actual, double tolerance) {
  std::vector<Point3> around(mesh.positions.size(), Point3{});  // sum of the neighbours
  std::vector<double> valence(mesh.positions.size(), 0.0);
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      add_scaled(around[t[i]], mesh.positions[t[(i + 1) % 3]], 1.0);
      valence[t[i]] += 1.0;
    }
  }
  std::vector<bool> explained(actual.size());
  for (std::size_t v = 0; v < actual.size(); ++v)
    explained[v] = distance(expected[v], actual[v]) <= tolerance;
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i];
      const std::uint32_t w = t[(i + 1) % 3];
      if (v >= actual.size() || explained[v]) continue;
      Point3 seen = around[w];
      add_scaled(seen, mesh.positions[v], -valence[w]);
      const Point3 from_v = cross(subtract(mesh.positions[w], mesh.positions[v]), seen);
      explained[v] = distance(expected[w], actual[v]) <= tolerance ||
                     distance(scaled_to_unit({from_v})[0], actual[v]) <= tolerance;
    }
  }
  return std::find(explained.begin(), explained.end(), false) == explained.end();
}

/// Nothing is named after the boundary where there is none.
void predict_at_boundary(const PolygonMesh& mesh, Predictions& predictions) {
  const auto loops = boundary_loops(mesh);
  if (loops.empty()) return;
  for (NormalWeight weight : {NormalWeight::kArea, NormalWeight::kEqual}) {
    for (LoopPart part : {LoopPart::kTriangle, LoopPart::kWhole}) {
      predictions.push_back({"boundary-face-counted", with_boundary_loop(mesh, weight, part)});
    }
  }
  Prediction<Point3> nothing{"nothing-at-boundary", vertex_normals(mesh, NormalWeight::kArea)};
  for (const auto& [vertex, after] : loops)
    nothing.points[vertex] = {NAN, NAN, NAN};
  predictions.push_back(std::move(nothing));
}

Predictions predict_normals(const PolygonMesh& mesh, const std::vector<Point3>& expected) {
  Predictions predictions{
      {"equal-weights", vertex_normals(mesh, NormalWeight::kEqual)},
      {"angle-weights", vertex_normals(mesh, NormalWeight::kAngle)},
      {"area-twice", vertex_normals(mesh, NormalWeight::kAreaSquared)},
      {"turned-around", multiplied(expected, -1.0)},
  };
  predict_positions_for_edges(mesh, predictions);
  predict_position_added(mesh, expected, predictions);
  if (boundary_loops(mesh).empty()) predict_neighbours_area(mesh, predictions);
  predict_at_boundary(mesh, predictions);
  return predictions;
}

bool all_agree(const std::vector<Point3>& expected, const std::vector<Point3>& actual,
               double tolerance) {
  for (std::size_t v = 0; v < actual.size(); ++v) {
    if (!(distance(expected[v], actual[v]) <= tolerance)) return false;
  }
  return true;
}

}  // namespace

std::map<std::uint32_t, std::uint32_t> boundary_loops(const PolygonMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i)
      sides.insert({t[i], t[(i + 1) % 3]});
  }
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : sides) {
    if (sides.count({to, from}) == 0) next[to] = from;
  }
  return next;
}

std::vector<Point3> vertex_normals(const PolygonMesh& mesh, NormalWeight weight) {
  return scaled_to_unit(weighted_sums(mesh, weight));
}

const Misconceptions& normal_misconceptions() {
  static const Misconceptions known{
      {"equal-weights", "every face counts the same: weight each normal by the face's area"},
      {"angle-weights", "the faces are weighted by their angles: area is asked"},
      {"area-twice",
       "the area counts twice: the cross product is weighted by the area already"},
      {"not-normalized", "the sum is right, but its length is not made 1"},
      {"positions-for-edges",
       "positions are multiplied in place of edges: the normal and the area of a face are "
       "those "
       "of (b - v) x (c - v), and must not depend on where the origin is"},
      {"position-added",
       "the position of the vertex is added to the sum: a normal is a direction, and begins as "
       "(0, 0, 0)"},
      {"neighbours-area",
       "every face has the area of the one next to it: take area and normal of a face from the "
       "same half-edge, before you go on to the next"},
      {"turned-around", "the normals point inwards: swap the factors of the cross product"},
      {"boundary-face-counted",
       "the boundary loop is counted as a face: skip faces with isBoundary()"},
      {"nothing-at-boundary",
       "on the boundary nothing is added up, and a vector of length 0 is scaled: does the walk "
       "end at the boundary loop? Skip the loop and go on"},
      {"one-face-only", "this is the normal of one face: go around the vertex, and add up all"},
      {"face-missed",
       "one face around the vertex is left out: the walk ends too early, or begins too late"},
      {"another-vertex",
       "these are the faces around a neighbour: h->next()->twin() walks around the vertex "
       "where "
       "h ends; h->twin()->next() walks around the one where it starts"},
  };
  return known;
}

Misconceptions recognize_normals(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                                 const std::vector<Point3>& actual, double tolerance) {
  const Misconceptions& known = normal_misconceptions();
  const std::vector<Point3> directions = directions_of(actual);
  Predictions predictions = predict_normals(mesh, expected);
  for (auto& prediction : predictions) {
    prediction.points = directions_of(std::move(prediction.points));
    prediction.points.resize(actual.size());
  }
  Misconceptions likely = recognize(known, predictions, directions, tolerance);
  if (all_agree(expected, directions, tolerance))
    likely.push_back(find_misconception(known, "not-normalized"));
  if (!likely.empty()) return likely;
  const auto alone = [](const Point3& area, const Point3& /*sum*/) {
    return scaled_to_unit({area})[0];
  };
  const auto without = [](const Point3& area, Point3 sum) {
    add_scaled(sum, area, -1.0);
    return scaled_to_unit({sum})[0];
  };
  if (some_face_explains(mesh, expected, directions, tolerance, alone)) {
    likely.push_back(find_misconception(known, "one-face-only"));
  }
  if (some_face_explains(mesh, expected, directions, tolerance, without)) {
    likely.push_back(find_misconception(known, "face-missed"));
  }
  // On an open mesh, a walk that is spoiled by the boundary gets to other faces as well.
  if (likely.empty() && boundary_loops(mesh).empty() &&
      some_neighbour_explains(mesh, expected, directions, tolerance)) {
    likely.push_back(find_misconception(known, "another-vertex"));
  }
  return likely;
}

}  // namespace meshgrade
