#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "vec2.h"

struct Vec3 {
  Vec3() = default;
  Vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
  explicit Vec3(const Vec2& v, float z_ = 0.0f) : x(v.x), y(v.y), z(z_) {}
  explicit Vec3(float all) : x(all), y(all), z(all) {}

  float& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  float operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }

  Vec3 operator+(const Vec3& v) const { return {x + v.x, y + v.y, z + v.z}; }
  Vec3 operator+(float s) const { return {x + s, y + s, z + s}; }
  Vec3& operator+=(const Vec3& v) { return *this = *this + v; }
  Vec3& operator+=(float s) { return *this = *this + s; }

  Vec3 operator-(const Vec3& v) const { return {x - v.x, y - v.y, z - v.z}; }
  Vec3 operator-(float s) const { return {x - s, y - s, z - s}; }
  Vec3& operator-=(const Vec3& v) { return *this = *this - v; }
  Vec3& operator-=(float s) { return *this = *this - s; }

  Vec3 operator*(const Vec3& v) const { return {x * v.x, y * v.y, z * v.z}; }
  Vec3 operator*(float s) const { return {x * s, y * s, z * s}; }
  Vec3& operator*=(const Vec3& v) { return *this = *this * v; }
  Vec3& operator*=(float s) { return *this = *this * s; }

  Vec3 operator/(const Vec3& v) const { return {x / v.x, y / v.y, z / v.z}; }
  Vec3 operator/(float s) const { return {x / s, y / s, z / s}; }
  Vec3& operator/=(const Vec3& v) { return *this = *this / v; }
  Vec3& operator/=(float s) { return *this = *this / s; }

  Vec3 operator-() const { return {-x, -y, -z}; }
  bool operator==(const Vec3& v) const { return x == v.x && y == v.y && z == v.z; }
  bool operator!=(const Vec3& v) const { return !(*this == v); }

  float norm_squared() const { return x * x + y * y + z * z; }
  float norm() const { return std::sqrt(norm_squared()); }
  /// The same direction, of length 1. Of the zero vector not a number.
  Vec3 unit() const { return *this / norm(); }
  /// Makes it its unit(). @return that
  Vec3 normalize() { return *this = unit(); }
  Vec3 abs() const { return {std::abs(x), std::abs(y), std::abs(z)}; }
  bool valid() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
  Vec2 xy() const { return {x, y}; }
  Vec2 xz() const { return {x, z}; }
  Vec2 yz() const { return {y, z}; }

  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

inline Vec3 operator+(float s, const Vec3& v) {
  return v + s;
}
inline Vec3 operator-(float s, const Vec3& v) {
  return -v + s;
}
inline Vec3 operator*(float s, const Vec3& v) {
  return v * s;
}
inline Vec3 operator/(float s, const Vec3& v) {
  return {s / v.x, s / v.y, s / v.z};
}

/// By the first component that differs.
inline bool operator<(const Vec3& l, const Vec3& r) {
  if (l.x != r.x) return l.x < r.x;
  if (l.y != r.y) return l.y < r.y;
  return l.z < r.z;
}

inline float dot(const Vec3& l, const Vec3& r) {
  return l.x * r.x + l.y * r.y + l.z * r.z;
}

inline Vec3 cross(const Vec3& l, const Vec3& r) {
  return {l.y * r.z - l.z * r.y, l.z * r.x - l.x * r.z, l.x * r.y - l.y * r.x};
}

/// The smaller and the larger, component by component.
inline Vec3 hmin(const Vec3& l, const Vec3& r) {
  return {std::min(l.x, r.x), std::min(l.y, r.y), std::min(l.z, r.z)};
}
inline Vec3 hmax(const Vec3& l, const Vec3& r) {
  return {std::max(l.x, r.x), std::max(l.y, r.y), std::max(l.z, r.z)};
}

inline std::ostream& operator<<(std::ostream& out, const Vec3& v) {
  return out << "{" << v.x << "," << v.y << "," << v.z << "}";
}

inline std::string to_string(const Vec3& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) +
         ")";
}
