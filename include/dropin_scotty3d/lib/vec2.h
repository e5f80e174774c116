#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

struct Vec2 {
  Vec2() = default;
  Vec2(float x_, float y_) : x(x_), y(y_) {}
  explicit Vec2(float all) : x(all), y(all) {}

  float& operator[](int i) { return i == 0 ? x : y; }
  float operator[](int i) const { return i == 0 ? x : y; }

  Vec2 operator+(const Vec2& v) const { return {x + v.x, y + v.y}; }
  Vec2 operator+(float s) const { return {x + s, y + s}; }
  Vec2& operator+=(const Vec2& v) { return *this = *this + v; }
  Vec2& operator+=(float s) { return *this = *this + s; }

  Vec2 operator-(const Vec2& v) const { return {x - v.x, y - v.y}; }
  Vec2 operator-(float s) const { return {x - s, y - s}; }
  Vec2& operator-=(const Vec2& v) { return *this = *this - v; }
  Vec2& operator-=(float s) { return *this = *this - s; }

  Vec2 operator*(const Vec2& v) const { return {x * v.x, y * v.y}; }
  Vec2 operator*(float s) const { return {x * s, y * s}; }
  Vec2& operator*=(const Vec2& v) { return *this = *this * v; }
  Vec2& operator*=(float s) { return *this = *this * s; }

  Vec2 operator/(const Vec2& v) const { return {x / v.x, y / v.y}; }
  Vec2 operator/(float s) const { return {x / s, y / s}; }
  Vec2& operator/=(const Vec2& v) { return *this = *this / v; }
  Vec2& operator/=(float s) { return *this = *this / s; }

  Vec2 operator-() const { return {-x, -y}; }
  bool operator==(const Vec2& v) const { return x == v.x && y == v.y; }
  bool operator!=(const Vec2& v) const { return !(*this == v); }

  float norm_squared() const { return x * x + y * y; }
  float norm() const { return std::sqrt(norm_squared()); }
  /// The same direction, of length 1. Of the zero vector not a number.
  Vec2 unit() const { return *this / norm(); }
  /// Makes it its unit(). @return that
  Vec2 normalize() { return *this = unit(); }
  Vec2 abs() const { return {std::abs(x), std::abs(y)}; }
  bool valid() const { return std::isfinite(x) && std::isfinite(y); }

  float x = 0.0f;
  float y = 0.0f;
};

inline Vec2 operator+(float s, const Vec2& v) {
  return v + s;
}
inline Vec2 operator-(float s, const Vec2& v) {
  return -v + s;
}
inline Vec2 operator*(float s, const Vec2& v) {
  return v * s;
}
inline Vec2 operator/(float s, const Vec2& v) {
  return {s / v.x, s / v.y};
}

/// By the first component that differs.
inline bool operator<(const Vec2& l, const Vec2& r) {
  if (l.x != r.x) return l.x < r.x;
  return l.y < r.y;
}

inline float dot(const Vec2& l, const Vec2& r) {
  return l.x * r.x + l.y * r.y;
}

/// The smaller and the larger, component by component.
inline Vec2 hmin(const Vec2& l, const Vec2& r) {
  return {std::min(l.x, r.x), std::min(l.y, r.y)};
}
inline Vec2 hmax(const Vec2& l, const Vec2& r) {
  return {std::max(l.x, r.x), std::max(l.y, r.y)};
}

inline std::ostream& operator<<(std::ostream& out, const Vec2& v) {
  return out << "{" << v.x << "," << v.y << "}";
}

inline std::string to_string(const Vec2& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ")";
}
