#pragma once

#include <cmath>
#include <ostream>

#include "meshedit/vector3d.h"

namespace meshedit {

/// A point or vector of space with a fourth component.
class Vector4D {
 public:
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 0.0;

  Vector4D() = default;
  Vector4D(double x_value, double y_value, double z_value, double w_value = 0.0)
      : x(x_value), y(y_value), z(z_value), w(w_value) {}
  // NOLINTBEGIN(google-explicit-constructor): the course's are implicit
  Vector4D(double c) : x(c), y(c), z(c), w(c) {}
  Vector4D(const Vector3D& v, double w_value = 0.0) : x(v.x), y(v.y), z(v.z), w(w_value) {}
  // NOLINTEND(google-explicit-constructor)

  double& operator[](int i) { return i < 2 ? (i == 0 ? x : y) : (i == 2 ? z : w); }
  const double& operator[](int i) const { return const_cast<Vector4D&>(*this)[i]; }

  Vector4D operator-() const { return {-x, -y, -z, -w}; }
  Vector4D operator+(const Vector4D& v) const { return {x + v.x, y + v.y, z + v.z, w + v.w}; }
  Vector4D operator-(const Vector4D& v) const { return {x - v.x, y - v.y, z - v.z, w - v.w}; }
  Vector4D operator*(double s) const { return {x * s, y * s, z * s, w * s}; }
  Vector4D operator/(double s) const { return {x / s, y / s, z / s, w / s}; }
  Vector4D& operator+=(const Vector4D& v) { return *this = *this + v; }
  Vector4D& operator-=(const Vector4D& v) { return *this = *this - v; }
  Vector4D& operator*=(double s) { return *this = *this * s; }
  Vector4D& operator/=(double s) { return *this = *this / s; }

  double norm2() const { return x * x + y * y + z * z + w * w; }
  double norm() const { return std::sqrt(norm2()); }
  Vector4D unit() const { return *this / norm(); }
  void normalize() { *this /= norm(); }

  Vector3D to3D() const { return {x, y, z}; }
  Vector3D projectTo3D() const { return {x / w, y / w, z / w}; }
};

inline Vector4D operator*(double s, const Vector4D& v) {
  return v * s;
}

inline double dot(const Vector4D& a, const Vector4D& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

inline std::ostream& operator<<(std::ostream& out, const Vector4D& v) {
  return out << "(" << v.x << "," << v.y << "," << v.z << "," << v.w << ")";
}

}  // namespace meshedit
