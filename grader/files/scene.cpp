#include "grader/files/scene.h"

#include <algorithm>
#include <cmath>

#include "grader/files/file_bytes.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostCorners = 20'000'000;

}  // namespace

Point3 Transform::operator()(const Point3& point) const {
  Point3 image{};
  for (std::size_t r = 0; r < 3; ++r) {
    image[r] =
        rows[r][0] * point[0] + rows[r][1] * point[1] + rows[r][2] * point[2] + rows[r][3];
  }
  return image;
}

bool Transform::is_mirror() const {
  const auto& [a, b, c] = rows;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]) <
         0;
}

Transform operator*(const Transform& outer, const Transform& inner) {
  Transform product;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      double sum = c == 3 ? outer.rows[r][3] : 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += outer.rows[r][k] * inner.rows[k][c];
      product.rows[r][c] = sum;
    }
  }
  return product;
}

Transform translation(const Point3& by) {
  Transform transform;
  for (std::size_t r = 0; r < 3; ++r)
    transform.rows[r][3] = by[r];
  return transform;
}

Transform scaling(const Point3& by) {
  Transform transform;
  for (std::size_t r = 0; r < 3; ++r)
    transform.rows[r][r] = by[r];
  return transform;
}

Transform rotation(const Point3& axis, double radians) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const double sine = std::sin(radians / 2) / length;
  return rotation({axis[0] * sine, axis[1] * sine, axis[2] * sine, std::cos(radians / 2)});
}

Transform rotation(const std::array<double, 4>& quaternion) {
  const auto [x, y, z, w] = quaternion;
  const double s = 2 / (x * x + y * y + z * z + w * w);
  Transform transform;
  transform.rows = {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), 0},
                     {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), 0},
                     {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), 0}}};
  return transform;
}

void append_part(PolygonMesh& whole, const PolygonMesh& part, const Transform& transform,
                 const std::filesystem::path& file, const std::string& place) {
  const std::size_t n_before = whole.positions.size() + whole.polygons.size();
  if (n_before + part.positions.size() + part.polygons.size() > kMostCorners) {
    refuse_file(file, place, "the scene has more than 20 million vertices and faces");
  }
  const auto first = static_cast<std::uint32_t>(whole.positions.size());
  for (const Point3& point : part.positions) {
    const Point3 image = transform(point);
    if (!std::isfinite(image[0]) || !std::isfinite(image[1]) || !std::isfinite(image[2])) {
      refuse_file(file, place, "a coordinate is not a finite number after the transforms");
    }
    whole.positions.push_back(image);
  }
  const bool is_mirror = transform.is_mirror();
  for (std::vector<std::uint32_t> polygon : part.polygons) {
    for (std::uint32_t& corner : polygon)
      corner += first;
    if (is_mirror) std::reverse(polygon.begin(), polygon.end());
    whole.polygons.push_back(std::move(polygon));
  }
}

}  // namespace meshgrade
