#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "vec3.h"

struct Vec4 {
  Vec4() = default;
  Vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
  Vec4(const Vec3& v, float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
  explicit Vec4(float all) : x(all), y(all), z(all), w(all) {}

  float& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
  float operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }

  Vec4 operator+(const Vec4& v) const { return {x + v.x, y + v.y, z + v.z, w + v.w}; }
  Vec4 operator+(float s) const { return {x + s, y + s, z + s, w + s}; }
  Vec4& operator+=(const Vec4& v) { return *this = *this + v; }
  Vec4& operator+=(float s) { return *this = *this + s; }

  Vec4 operator-(const Vec4& v) const { return {x - v.x, y - v.y, z - v.z, w - v.w}; }
  Vec4 operator-(float s) const { return {x - s, y - s, z - s, w - s}; }
  Vec4& operator-=(const Vec4& v) { return *this = *this - v; }
  Vec4& operator-=(float s) { return *this = *this - s; }

  Vec4 operator*(const Vec4& v) const { return {x * v.x, y * v.y, z * v.z, w * v.w}; }
  Vec4 operator*(float s) const { return {x * s, y * s, z * s, w * s}; }
  Vec4& operator*=(const Vec4& v) { return *this = *this * v; }
  Vec4& operator*=(float s) { return *this = *this * s; }

  Vec4 operator/(const Vec4& v) const { return {x / v.x, y / v.y, z / v.z, w / v.w}; }
  Vec4 operator/(float s) const { return {x / s, y / s, z / s, w / s}; }
  Vec4& operator/=(const Vec4& v) { return *this = *this / v; }
  Vec4& operator/=(float s) { return *this = *this / s; }

  Vec4 operator-() const { return {-x, -y, -z, -w}; }
  bool operator==(const Vec4& v) const { return x == v.x && y == v.y && z == v.z && w == v.w; }
  bool operator!=(const Vec4& v) const { return !(*this == v); }

  float norm_squared() const { return x * x + y * y + z * z + w * w; }
  float norm() const { return std::sqrt(norm_squared()); }
  /// The same direction, of length 1. Of the zero vector not a number.
  Vec4 unit() const { return *this / norm(); }
  /// Makes it its unit(). @return that
  Vec4 normalize() { return *this = unit(); }
  Vec4 abs() const { return {std::abs(x), std::abs(y), std::abs(z), std::abs(w)}; }
  bool valid() const {
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(w);
  }
  Vec2 xy() const { return {x, y}; }
  Vec3 xyz() const { return {x, y, z}; }
  /// The point with these homogeneous coordinates.
  Vec3 project() const { return {x / w, y / w, z / w}; }

  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
  float w = 0.0f;
};

inline Vec4 operator+(float s, const Vec4& v) {
  return v + s;
}
inline Vec4 operator-(float s, const Vec4& v) {
  return -v + s;
}
inline Vec4 operator*(float s, const Vec4& v) {
  return v * s;
}
inline Vec4 operator/(float s, const Vec4& v) {
  return {s / v.x, s / v.y, s / v.z, s / v.w};
}

/// By the first component that differs.
inline bool operator<(const Vec4& l, const Vec4& r) {
  if (l.x != r.x) return l.x < r.x;
  if (l.y != r.y) return l.y < r.y;
  if (l.z != r.z) return l.z < r.z;
  return l.w < r.w;
}

inline float dot(const Vec4& l, const Vec4& r) {
  return l.x * r.x + l.y * r.y + l.z * r.z + l.w * r.w;
}

/// The smaller and the larger, component by component.
inline Vec4 hmin(const Vec4& l, const Vec4& r) {
  return {std::min(l.x, r.x), std::min(l.y, r.y), std::min(l.z, r.z), std::min(l.w, r.w)};
}
inline Vec4 hmax(const Vec4& l, const Vec4& r) {
  return {std::max(l.x, r.x), std::max(l.y, r.y), std::max(l.z, r.z), std::max(l.w, r.w)};
}

inline std::ostream& operator<<(std::ostream& out, const Vec4& v) {
  return out << "{" << v.x << "," << v.y << "," << v.z << "," << v.w << "}";
}

inline std::string to_string(const Vec4& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) +
         ", " + std::to_string(v.w) + ")";
}
