#include "grader/judge/normals.h"

#include <cmath>
#include <map>
#include <utility>

namespace meshgrade {
namespace {

Point3 subtract(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

void add(Point3& sum, const Point3& a, double factor) {
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
      add(sums[t[i]], area, factor);
    }
  }
  return sums;
}

/// For each boundary vertex the unit normal of its boundary loop, which is no face of the
/// surface; zero for the others. The loop runs against the faces, so its normal points inwards.
std::vector<Point3> boundary_loop_areas(const PolygonMesh& mesh) {
  std::map<std::uint32_t, std::uint32_t> next;  // along the loop, against the faces
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : mesh.polygons) {
    for (std::size_t i = 0; i < 3; ++i)
      ++sides[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : sides) {
    if (sides.count({edge.second, edge.first}) == 0) next[edge.second] = edge.first;
  }
  std::vector<Point3> areas(mesh.positions.size(), Point3{});
  for (const auto& [vertex, after] : next) {
    Point3 area{};
    const Point3& origin = mesh.positions[vertex];
    for (std::uint32_t v = after; next.at(v) != vertex; v = next.at(v)) {
      add(area,
          cross(subtract(mesh.positions[v], origin),
                subtract(mesh.positions[next.at(v)], origin)),
          1.0);
    }
    areas[vertex] = area;
  }
  return areas;
}

std::vector<Point3> with_boundary_loop(const PolygonMesh& mesh, NormalWeight weight) {
  std::vector<Point3> sums = weighted_sums(mesh, weight);
  const std::vector<Point3> loops = boundary_loop_areas(mesh);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double size = length(loops[v]);
    if (size > 0.0) add(sums[v], loops[v], weight == NormalWeight::kEqual ? 1.0 / size : 1.0);
  }
  return scaled_to_unit(std::move(sums));
}

std::vector<Point3> negated(std::vector<Point3> vectors) {
  for (Point3& v : vectors)
    v = {-v[0], -v[1], -v[2]};
  return vectors;
}

/// True if every normal that is wrong becomes right by leaving one face of its fan out.
bool misses_one_face(const PolygonMesh& mesh, const std::vector<Point3>& expected,
                     const std::vector<Point3>& actual, double tolerance) {
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
      Point3 rest = sums[v];
      add(rest, area, -1.0);
      explained[v] = distance(scaled_to_unit({rest})[0], actual[v]) <= tolerance;
    }
  }
  for (bool e : explained) {
    if (!e) return false;
  }
  return true;
}

}  // namespace

std::vector<Point3> vertex_normals(const PolygonMesh& mesh, NormalWeight weight) {
  return scaled_to_unit(weighted_sums(mesh, weight));
}

std::vector<Misconception> recognize_normals(const PolygonMesh& mesh,
                                             const std::vector<Point3>& expected,
                                             const std::vector<Point3>& actual,
                                             double tolerance) {
  std::vector<Point3> halved = weighted_sums(mesh, NormalWeight::kArea);
  for (Point3& v : halved)
    v = {0.5 * v[0], 0.5 * v[1], 0.5 * v[2]};
  std::vector<Prediction<Point3>> predictions{
      {{"equal-weights", "every face counts the same: weight each normal by the face's area"},
       vertex_normals(mesh, NormalWeight::kEqual)},
      {{"angle-weights", "the faces are weighted by their angles: area is asked"},
       vertex_normals(mesh, NormalWeight::kAngle)},
      {{"area-twice",
        "the area counts twice: the cross product is weighted by the area already"},
       vertex_normals(mesh, NormalWeight::kAreaSquared)},
      {{"not-normalized", "the sum is right, but its length is not made 1"},
       weighted_sums(mesh, NormalWeight::kArea)},
      {{"not-normalized", "the sum is right, but its length is not made 1"}, halved},
      {{"turned-around", "the normals point inwards: swap the factors of the cross product"},
       negated(expected)},
      {{"boundary-face-counted",
        "the boundary loop is counted as a face: skip faces with isBoundary()"},
       with_boundary_loop(mesh, NormalWeight::kArea)},
      {{"boundary-face-counted",
        "the boundary loop is counted as a face: skip faces with isBoundary()"},
       with_boundary_loop(mesh, NormalWeight::kEqual)},
  };
  for (auto& prediction : predictions)
    prediction.points.resize(actual.size());
  std::vector<Misconception> likely = recognize(predictions, actual, tolerance);
  if (likely.empty() && misses_one_face(mesh, expected, actual, tolerance)) {
    likely.push_back({"face-missed",
                      "one face around the vertex is left out: the walk ends too "
                      "early, or begins too late"});
  }
  return likely;
}

}  // namespace meshgrade
