#include "grader/judge/quadric_collapses.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "grader/judge/point_compare.h"
#include "grader/mesh/point_products.h"

namespace meshgrade {
namespace {

Point3 middle_of(const Point3& p, const Point3& q) {
  return {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])};
}

Point3 mirrored_point(const Point3& p) {
  return {-p[0], -p[1], -p[2]};
}

/// The best of both ends and the middle.
Point3 best_of_three(const Quadric& edge, const Point3& p, const Point3& q) {
  const std::vector<Point3> all{middle_of(p, q), p, q};
  return *std::min_element(all.begin(), all.end(), [&](const Point3& x, const Point3& y) {
    return edge.at(x) < edge.at(y);
  });
}

Point3 best_place(const Quadric& edge, const Point3& p, const Point3& q) {
  return least_point(edge).value_or(best_of_three(edge, p, q));
}

Point3 mirrored_place(const Quadric& edge, const Point3& p, const Point3& q) {
  const auto least = least_point(edge);
  return least ? mirrored_point(*least) : best_of_three(edge, p, q);
}

Point3 middle_place(const Quadric& /*edge*/, const Point3& p, const Point3& q) {
  return middle_of(p, q);
}

double cost_rank(const Quadric& edge, const Point3& /*p*/, const Point3& /*q*/,
                 const Point3& at) {
  return edge.at(at);
}

double dearest_rank(const Quadric& edge, const Point3& /*p*/, const Point3& /*q*/,
                    const Point3& at) {
  return -edge.at(at);
}

/// Of a point that is found with the wrong sign in front of the offset of each plane: there the
/// wrong quadric is what the right one is at its own least point.
double mirrored_rank(const Quadric& edge, const Point3& /*p*/, const Point3& /*q*/,
                     const Point3& at) {
  return edge.at(mirrored_point(at));
}

double length_rank(const Quadric& /*edge*/, const Point3& p, const Point3& q,
                   const Point3& /*at*/) {
  return distance(p, q);
}

Quadric weighed_by_area(const Point3& p, const Point3& q, const Point3& r) {
  const Point3 n = area_vector(p, q, r);
  return 0.5 * std::hypot(n[0], n[1], n[2]) * plane_quadric(p, q, r);
}

Quadric not_normalized(const Point3& p, const Point3& q, const Point3& r) {
  const Point3 n = area_vector(p, q, r);
  return (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) * plane_quadric(p, q, r);
}

LabelPair sorted_ends(Label a, Label b) {
  return std::minmax(a, b);
}

bool has_corner(const Corners& face, Label corner) {
  return std::find(face.begin(), face.end(), corner) != face.end();
}

}  // namespace

const std::vector<CollapseWay>& right_collapse_ways() {
  static const std::vector<CollapseWay> ways{{"planes", plane_quadric, best_place, cost_rank},
                                             {"areas", weighed_by_area, best_place, cost_rank}};
  return ways;
}

const std::vector<CollapseWay>& wrong_collapse_ways() {
  const auto way = [](const char* name) {
    return CollapseWay{name, plane_quadric, best_place, cost_rank};
  };
  static const std::vector<CollapseWay> ways = [&] {
    std::vector<CollapseWay> all{{"offset-sign", plane_quadric, mirrored_place, mirrored_rank},
                                 {"optimum-sign", plane_quadric, mirrored_place, cost_rank},
                                 {"middle", plane_quadric, middle_place, cost_rank},
                                 {"ends-and-middle", plane_quadric, best_of_three, cost_rank},
                                 {"dearest-first", plane_quadric, best_place, dearest_rank},
                                 {"shortest-first", plane_quadric, best_place, length_rank},
                                 {"not-normalized", not_normalized, best_place, cost_rank}};
    all.push_back(way("not-moved"));
    all.back().is_moved = false;
    all.push_back(way("shared-faces-once"));
    all.back().shares_count_once = true;
    all.push_back(way("quadrics-anew"));
    all.back().is_anew = true;
    all.push_back(way("costs-not-renewed"));
    all.back().renewal = Renewal::kOldCosts;
    all.push_back(all.back());
    all.back().renewal = Renewal::kOldBest;
    return all;
  }();
  return ways;
}

CollapsingMesh::CollapsingMesh(const FaceLists& mesh, const CollapseWay& way)
    : lists_(mesh), way_(&way), surface_(lists_) {
  for (const Corners& face : lists_.faces) {
    const auto& p = lists_.positions;
    const Quadric quadric = way_->of_face(p[face[0]], p[face[1]], p[face[2]]);
    for (const Label corner : face)
      quadrics_[corner] = quadrics_[corner] + quadric;
  }
}

std::vector<LabelPair> CollapsingMesh::edges() const {
  std::set<LabelPair> all;
  for (const Corners& face : lists_.faces) {
    for (std::size_t i = 0; i < 3; ++i)
      all.insert(sorted_ends(face[i], face[(i + 1) % 3]));
  }
  return {all.begin(), all.end()};
}

// The link condition of Dey, Edelsbrunner, Guha and Nekhayev (1999), for surfaces.
bool CollapsingMesh::is_sound(const LabelPair& edge) const {
  const auto [a, b] = edge;
  if (surface_.is_boundary(a) && surface_.is_boundary(b) && !surface_.is_boundary_edge(a, b))
    return false;
  std::size_t beside = 0;
  for (const std::size_t face : surface_.faces_at(a))
    beside += has_corner(lists_.faces[face], b) ? 1U : 0U;
  std::vector<Label> common;
  const auto of_a = surface_.neighbours(a);
  const auto of_b = surface_.neighbours(b);
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(common));
  if (common.size() != beside) return false;
  // A third corner that keeps two edges only: what is left lies on itself, or there is nothing.
  return std::all_of(common.begin(), common.end(), [&](Label corner) {
    return surface_.neighbours(corner).size() > (surface_.is_boundary(corner) ? 2U : 3U);
  });
}

bool CollapsingMesh::turns_a_face(const LabelPair& edge, const Point3& at) const {
  constexpr double kMuch = 0.2;  // the cosine; programs that look at this ask for 0 to 0.2
  const auto turns = [&](std::size_t index) {
    const Corners& face = lists_.faces[index];
    if (has_corner(face, edge.first) && has_corner(face, edge.second)) return false;
    std::vector<Point3> old;
    std::vector<Point3> moved;
    for (const Label corner : face) {
      old.push_back(lists_.positions[corner]);
      moved.push_back(corner == edge.first || corner == edge.second ? at : old.back());
    }
    const Point3 n = area_vector(old[0], old[1], old[2]);
    const Point3 m = area_vector(moved[0], moved[1], moved[2]);
    return !(dot(n, m) > kMuch * std::sqrt(dot(n, n) * dot(m, m)));
  };
  const auto at_a = surface_.faces_at(edge.first);
  const auto at_b = surface_.faces_at(edge.second);
  return std::any_of(at_a.begin(), at_a.end(), turns) ||
         std::any_of(at_b.begin(), at_b.end(), turns);
}

Quadric CollapsingMesh::quadric_of(const LabelPair& edge) const {
  Quadric sum = quadrics_.at(edge.first) + quadrics_.at(edge.second);
  if (!way_->shares_count_once) return sum;
  for (const std::size_t index : surface_.faces_at(edge.first)) {
    const Corners& face = lists_.faces[index];
    if (!has_corner(face, edge.second)) continue;
    const auto& p = lists_.positions;
    sum = sum + -1.0 * way_->of_face(p[face[0]], p[face[1]], p[face[2]]);
  }
  return sum;
}

EdgeCost CollapsingMesh::cost(const LabelPair& edge) const {
  const Quadric quadric = quadric_of(edge);
  const auto least = least_point(quadric);
  const double cost = least ? std::max(0.0, quadric.at(*least)) : 0.0;
  if (least && has_single_least_point(quadric)) return {cost, cost, *least, true};
  const Point3 at =
      best_of_three(quadric, lists_.positions[edge.first], lists_.positions[edge.second]);
  return {cost, std::max(cost, quadric.at(at)), at, false};
}

double CollapsingMesh::rank(const LabelPair& edge, Point3& at) const {
  const Quadric quadric = quadric_of(edge);
  const Point3& p = lists_.positions[edge.first];
  const Point3& q = lists_.positions[edge.second];
  at = way_->place(quadric, p, q);
  const double rank = way_->rank(quadric, p, q, at);
  if (!way_->is_moved) at = middle_of(p, q);
  return rank;
}

double CollapsingMesh::rounding(const LabelPair& edge) const {
  double most = 0.0;
  for (const Label end : {edge.first, edge.second}) {
    for (const double x : lists_.positions[end])
      most = std::max(most, std::abs(x));
  }
  return float_rounding(quadric_of(edge).trace() * most * most);
}

CollapsingMesh CollapsingMesh::collapsed(const LabelPair& edge, const Point3& at) const {
  const auto [left, gone] = edge;
  FaceLists lists = merged(lists_, {left, gone}, left);
  lists.positions[left] = at;
  CollapsingMesh after(lists, *way_);
  const Quadric anew = after.quadrics_[left];
  after.quadrics_ = quadrics_;
  after.quadrics_[left] = way_->is_anew ? anew : quadric_of(edge);
  after.members_ = members_;
  const auto members_of = [&](Label v) {
    const auto known = members_.find(v);
    return known == members_.end() ? std::vector<Label>{v} : known->second;
  };
  std::vector<Label> members = members_of(left);
  for (const Label member : members_of(gone))
    members.push_back(member);
  after.members_.erase(gone);
  after.members_[left] = members;
  return after;
}

}  // namespace meshgrade
