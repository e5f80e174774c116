#pragma once

#include <cmath>
#include <ostream>

namespace meshedit {

/// A point or vector of space.
class Vector3D {
 public:
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  Vector3D() = default;
  Vector3D(double x_value, double y_value, double z_value)
      : x(x_value), y(y_value), z(z_value) {}
  /// (c, c, c), so that `v->newPosition = 0` may be written.
  Vector3D(double c) : x(c), y(c), z(c) {}  // NOLINT(google-explicit-constructor)

  double& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
  const double& operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }

  Vector3D operator-() const { return {-x, -y, -z}; }
  Vector3D operator+(const Vector3D& v) const { return {x + v.x, y + v.y, z + v.z}; }
  Vector3D operator-(const Vector3D& v) const { return {x - v.x, y - v.y, z - v.z}; }
  Vector3D operator*(double s) const { return {x * s, y * s, z * s}; }
  Vector3D operator/(double s) const { return {x / s, y / s, z / s}; }
  Vector3D& operator+=(const Vector3D& v) { return *this = *this + v; }
  Vector3D& operator-=(const Vector3D& v) { return *this = *this - v; }
  Vector3D& operator*=(double s) { return *this = *this * s; }
  Vector3D& operator/=(double s) { return *this = *this / s; }

  /// The length.
  double norm() const { return std::sqrt(norm2()); }
  /// The length squared.
  double norm2() const { return x * x + y * y + z * z; }
  /// The vector of length 1 in the same direction. The zero vector has none: it gives NaN.
  Vector3D unit() const { return *this / norm(); }
  /// Scales this vector to length 1.
  void normalize() { *this /= norm(); }
};

inline Vector3D operator*(double s, const Vector3D& v) {
  return v * s;
}

inline double dot(const Vector3D& a, const Vector3D& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector3D cross(const Vector3D& a, const Vector3D& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline std::ostream& operator<<(std::ostream& out, const Vector3D& v) {
  return out << "(" << v.x << "," << v.y << "," << v.z << ")";
}

}  // namespace meshedit
