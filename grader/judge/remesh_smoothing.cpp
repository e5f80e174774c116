#include "grader/judge/remesh_smoothing.h"

#include <algorithm>
#include <cmath>

#include "grader/mesh/point_products.h"

namespace meshgrade {
namespace {

Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double norm_of(const Point3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

Point3 plus(const Point3& a, double factor, const Point3& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// What a vertex is moved by, from where it lies, the sum of its neighbours, their number, and
/// its normal.
struct Surroundings {
  Point3 at;
  Point3 sum;
  double valence;
  Point3 normal;

  Point3 mean() const { return plus({}, 1.0 / valence, sum); }
};

Point3 along_surface(const Point3& u, const Point3& normal) {
  return plus(u, -dot(u, normal), normal);
}

/// The rules: what is added to a position, from what lies around.
using MoveRule = Point3 (*)(const Surroundings& s, double step);

Point3 right_move(const Surroundings& s, double step) {
  return plus({}, step, along_surface(difference(s.mean(), s.at), s.normal));
}

Point3 unprojected_move(const Surroundings& s, double step) {
  return plus({}, step, difference(s.mean(), s.at));
}

Point3 whole_move(const Surroundings& s, double /*step*/) {
  return right_move(s, 1.0);
}

Point3 move_away(const Surroundings& s, double step) {
  return right_move(s, -step);
}

Point3 move_along_normal(const Surroundings& s, double step) {
  const Point3 u = difference(s.mean(), s.at);
  return plus({}, step * dot(u, s.normal), s.normal);
}

Point3 move_with_itself(const Surroundings& s, double step) {
  return right_move({s.at, plus(s.sum, 1.0, s.at), s.valence + 1.0, s.normal}, step);
}

/// The mean of the centres of the triangles around: two thirds of the way.
Point3 move_to_centres(const Surroundings& s, double step) {
  return right_move(s, 2.0 / 3.0 * step);
}

Point3 undivided_move(const Surroundings& s, double step) {
  return right_move({s.at, s.sum, 1.0, s.normal}, step);
}

/// The new position is put into the plane through the origin, and not the way to it.
Point3 projected_position(const Surroundings& s, double step) {
  const Point3 there = plus(s.at, step, difference(s.mean(), s.at));
  return difference(along_surface(there, s.normal), s.at);
}

Surroundings surroundings(const TriangleRings& rings, const std::vector<Point3>& at, Label v,
                          const Point3& normal) {
  Surroundings s{at[v], {}, static_cast<double>(rings.neighbours[v].size()), normal};
  for (const Label neighbour : rings.neighbours[v])
    s.sum = plus(s.sum, 1.0, at[neighbour]);
  return s;
}

std::vector<Point3> moved_at_once(const TriangleRings& rings, const std::vector<Point3>& at,
                                  const std::vector<Point3>& normals, MoveRule rule,
                                  double step) {
  std::vector<Point3> after = at;
  for (Label v = 0; v < at.size(); ++v) {
    if (rings.neighbours[v].empty()) continue;
    after[v] = plus(at[v], 1.0, rule(surroundings(rings, at, v, normals[v]), step));
  }
  return after;
}

std::vector<Point3> iterated(const TriangleRings& rings, std::vector<Point3> at, MoveRule rule,
                             double step, std::uint32_t iterations) {
  for (std::uint32_t i = 0; i < iterations; ++i)
    at = moved_at_once(rings, at, ring_normals(rings, at, NormalWeight::kArea), rule, step);
  return at;
}

/// Each vertex at once, in the order of their numbers.
/// @param old_normals  whether the normals are those from before
std::vector<Point3> one_by_one(const TriangleRings& rings, std::vector<Point3> at, double step,
                               std::uint32_t iterations, bool old_normals) {
  for (std::uint32_t i = 0; i < iterations; ++i) {
    const std::vector<Point3> before = ring_normals(rings, at, NormalWeight::kArea);
    for (Label v = 0; v < at.size(); ++v) {
      if (rings.neighbours[v].empty()) continue;
      const Point3 normal =
          old_normals ? before[v] : ring_normals(rings, at, NormalWeight::kArea)[v];
      at[v] = plus(at[v], 1.0, right_move(surroundings(rings, at, v, normal), step));
    }
  }
  return at;
}

/// The means, or the normals, are those from before the first iteration.
std::vector<Point3> with_old(bool means, const TriangleRings& rings, std::vector<Point3> at,
                             double step, std::uint32_t iterations) {
  const std::vector<Point3> first = at;
  const std::vector<Point3> normals = ring_normals(rings, first, NormalWeight::kArea);
  for (std::uint32_t i = 0; i < iterations; ++i) {
    const std::vector<Point3> now =
        means ? ring_normals(rings, at, NormalWeight::kArea) : normals;
    std::vector<Point3> after = at;
    for (Label v = 0; v < at.size(); ++v) {
      if (rings.neighbours[v].empty()) continue;
      Surroundings s = surroundings(rings, means ? first : at, v, now[v]);
      s.at = at[v];
      after[v] = plus(at[v], 1.0, right_move(s, step));
    }
    at = after;
  }
  return at;
}

constexpr std::size_t kMostForOneByOne = 200;  ///< vertices: it takes time by their square

void predict_order(const TriangleRings& rings, const std::vector<Point3>& at,
                   const RemeshSettings& settings,
                   std::vector<Prediction<Point3>>& predictions) {
  const std::uint32_t all = settings.outer * settings.smoothing;
  for (const bool old_normals : {false, true}) {
    if (at.size() > kMostForOneByOne && !old_normals) continue;
    predictions.push_back(
        {"moved-one-by-one", one_by_one(rings, at, settings.step, all, old_normals)});
  }
  if (settings.smoothing > 1) {
    for (const bool means : {true, false}) {
      std::vector<Point3> points = at;
      for (std::uint32_t round = 0; round < settings.outer; ++round)
        points = with_old(means, rings, points, settings.step, settings.smoothing);
      predictions.push_back({means ? "means-once" : "normals-once", std::move(points)});
    }
    predictions.push_back(
        {"smoothed-once", iterated(rings, at, right_move, settings.step, settings.outer)});
  }
  if (settings.outer > 1) {
    predictions.push_back(
        {"one-round", iterated(rings, at, right_move, settings.step, settings.smoothing)});
  }
}

}  // namespace

bool TriangleRings::is_closed() const {
  return std::find(on_boundary.begin(), on_boundary.end(), true) == on_boundary.end();
}

TriangleRings triangle_rings(const MeshDump& mesh, const std::vector<Label>& labels,
                             std::size_t size) {
  TriangleRings rings;
  rings.neighbours.resize(size);
  rings.on_boundary.resize(size, false);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live == 0) continue;
    const Label start = labels[h.vertex];
    rings.neighbours[start].push_back(labels[mesh.halfedges[h.twin].vertex]);
    if ((h.face & kBoundaryBit) != 0) rings.on_boundary[start] = true;
  }
  for (const FaceRecord& f : mesh.faces) {
    if (f.live == 0) continue;
    const HalfedgeRecord& first = mesh.halfedges[f.halfedge];
    const HalfedgeRecord& second = mesh.halfedges[first.next];
    rings.triangles.push_back({labels[first.vertex], labels[second.vertex],
                               labels[mesh.halfedges[second.next].vertex]});
  }
  return rings;
}

std::vector<Point3> ring_normals(const TriangleRings& rings, const std::vector<Point3>& at,
                                 NormalWeight weight) {
  std::vector<Point3> normals(at.size(), Point3{});
  for (const auto& t : rings.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 q = difference(at[t[(i + 1) % 3]], at[t[i]]);
      const Point3 r = difference(at[t[(i + 2) % 3]], at[t[i]]);
      const Point3 area = cross(q, r);
      const double size = norm_of(area);
      double factor = 1.0;
      if (weight == NormalWeight::kEqual) factor = 1.0 / size;
      if (weight == NormalWeight::kAngle) factor = std::atan2(size, dot(q, r)) / size;
      normals[t[i]] = plus(normals[t[i]], factor, area);
    }
  }
  for (Point3& normal : normals)
    normal = plus({}, 1.0 / norm_of(normal), normal);
  return normals;
}

std::vector<Point3> smoothed(const TriangleRings& rings, std::vector<Point3> at, double step,
                             std::uint32_t iterations, NormalWeight weight) {
  for (std::uint32_t i = 0; i < iterations; ++i)
    at = moved_at_once(rings, at, ring_normals(rings, at, weight), right_move, step);
  return at;
}

const Misconceptions& smoothing_misconceptions() {
  static const Misconceptions all{
      {"moved-one-by-one",
       "each vertex is moved at once, so that the next one sees where it has gone: compute all "
       "new positions first, and move all last"},
      {"not-along-the-surface",
       "the vertices go to the mean of their neighbours, and not only along the surface: take "
       "the part along the normal away, u - (u . N) N. Otherwise the mesh shrinks"},
      {"step-ignored", "the vertices go all the way: multiply it with smoothingStep"},
      {"away-from-the-mean",
       "the vertices go away from the mean of their neighbours: u is the mean minus p"},
      {"along-the-normal",
       "the part of u along the normal is what the vertices are moved by; it is what has to be "
       "taken away from u"},
      {"mean-with-itself", "the vertex itself is counted among its neighbours"},
      {"mean-of-centres",
       "the vertices go to the mean of the centres of their triangles, and not of their "
       "neighbours"},
      {"sum-for-mean", "the sum of the neighbours is not divided by their number"},
      {"position-projected",
       "the new position is projected, and not the way to it: p + s u - ((p + s u) . N) N lies "
       "in a plane through the origin"},
      {"means-once",
       "the means are those from before the first iteration: each iteration begins with where "
       "the one before it has left the vertices"},
      {"normals-once",
       "the normals are those from before the first iteration: each iteration has its own"},
      {"smoothed-once", "each round smooths once, and not smoothingIterations times"},
      {"one-round", "there is one round, and not outerIterations"}};
  return all;
}

std::vector<Prediction<Point3>> predict_smoothing(const TriangleRings& rings,
                                                  const std::vector<Point3>& at,
                                                  const RemeshSettings& settings) {
  const std::pair<const char*, MoveRule> rules[] = {{"not-along-the-surface", unprojected_move},
                                                    {"step-ignored", whole_move},
                                                    {"away-from-the-mean", move_away},
                                                    {"along-the-normal", move_along_normal},
                                                    {"mean-with-itself", move_with_itself},
                                                    {"mean-of-centres", move_to_centres},
                                                    {"sum-for-mean", undivided_move},
                                                    {"position-projected", projected_position}};
  std::vector<Prediction<Point3>> predictions;
  const std::uint32_t all = settings.outer * settings.smoothing;
  for (const auto& [name, rule] : rules)
    predictions.push_back({name, iterated(rings, at, rule, settings.step, all)});
  predict_order(rings, at, settings, predictions);
  return predictions;
}

}  // namespace meshgrade
