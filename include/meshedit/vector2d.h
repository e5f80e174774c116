#pragma once

#include <cmath>
#include <ostream>

namespace meshedit {

/// A point or vector of the plane.
class Vector2D {
 public:
  double x = 0.0;
  double y = 0.0;

  Vector2D() = default;
  Vector2D(double x_value, double y_value) : x(x_value), y(y_value) {}

  Vector2D operator-() const { return {-x, -y}; }
  Vector2D operator+(const Vector2D& v) const { return {x + v.x, y + v.y}; }
  Vector2D operator-(const Vector2D& v) const { return {x - v.x, y - v.y}; }
  Vector2D operator*(double s) const { return {x * s, y * s}; }
  Vector2D operator/(double s) const { return {x / s, y / s}; }
  Vector2D& operator+=(const Vector2D& v) { return *this = *this + v; }
  Vector2D& operator-=(const Vector2D& v) { return *this = *this - v; }
  Vector2D& operator*=(double s) { return *this = *this * s; }
  Vector2D& operator/=(double s) { return *this = *this / s; }

  /// The length.
  double norm() const { return std::sqrt(norm2()); }
  /// The length squared.
  double norm2() const { return x * x + y * y; }
  /// The vector of length 1 in the same direction. The zero vector has none: it gives NaN.
  Vector2D unit() const { return *this / norm(); }
};

inline Vector2D operator*(double s, const Vector2D& v) {
  return v * s;
}

inline double dot(const Vector2D& a, const Vector2D& b) {
  return a.x * b.x + a.y * b.y;
}

/// The z component of the cross product: twice the signed area of the triangle (0, a, b).
inline double cross(const Vector2D& a, const Vector2D& b) {
  return a.x * b.y - a.y * b.x;
}

inline std::ostream& operator<<(std::ostream& out, const Vector2D& v) {
  return out << "(" << v.x << "," << v.y << ")";
}

}  // namespace meshedit
