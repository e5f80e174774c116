#include "grader/report/projection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace meshgrade {

using meshedit::Vector3D;

Vector3D vector_of(const Point3& p) {
  return {p[0], p[1], p[2]};
}

bool is_finite(const Vector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Projection::Projection(const Vector3D& towards, const Vector3D& up)
    : towards_(towards), right_(cross(up, towards).unit()), up_(cross(towards, right_)) {}

Spot Projection::on_screen(const Point3& p) const {
  const Vector3D v = vector_of(p);
  return {dot(v, right_), -dot(v, up_)};
}

double Projection::depth(const Point3& p) const {
  return dot(vector_of(p), towards_);
}

double Projection::facing(const Point3& a, const Point3& b, const Point3& c) const {
  const Vector3D p = vector_of(a);
  const Vector3D across = cross(vector_of(b) - p, vector_of(c) - p).unit();
  return is_finite(across) ? dot(across, towards_) : 0.0;
}

std::vector<std::size_t> far_to_near(const std::vector<double>& depths) {
  std::vector<std::size_t> order(depths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // A depth that is no number has no place in an order.
  const auto known = [&](std::size_t i) {
    return std::isfinite(depths[i]) ? depths[i] : -INFINITY;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return known(i) < known(j); });
  return order;
}

}  // namespace meshgrade
