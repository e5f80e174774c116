#pragma once

#include <ostream>

#include "vec3.h"
#include "vec4.h"

/// A matrix by its columns.
struct Mat4 {
  static const Mat4 I;
  static const Mat4 Zero;

  Mat4() : Mat4(Vec4(1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, 0, 0, 1)) {}
  Mat4(const Vec4& x, const Vec4& y, const Vec4& z, const Vec4& w) : cols{x, y, z, w} {}

  /// The matrix l r^T.
  static Mat4 outer(const Vec4& l, const Vec4& r) {
    return {l * r.x, l * r.y, l * r.z, l * r.w};
  }
  static Mat4 transpose(const Mat4& m) { return m.T(); }
  static Mat4 inverse(const Mat4& m) { return m.inverse(); }
  static Mat4 translate(const Vec3& t) {
    Mat4 m;
    m.cols[3] = Vec4(t, 1.0f);
    return m;
  }
  static Mat4 scale(const Vec3& s) {
    return {Vec4(s.x, 0, 0, 0), Vec4(0, s.y, 0, 0), Vec4(0, 0, s.z, 0), Vec4(0, 0, 0, 1)};
  }

  Vec4& operator[](int column) { return cols[column]; }
  Vec4 operator[](int column) const { return cols[column]; }

  Mat4 operator+(const Mat4& m) const {
    return {cols[0] + m[0], cols[1] + m[1], cols[2] + m[2], cols[3] + m[3]};
  }
  Mat4 operator-(const Mat4& m) const {
    return {cols[0] - m[0], cols[1] - m[1], cols[2] - m[2], cols[3] - m[3]};
  }
  Mat4 operator*(float s) const { return {cols[0] * s, cols[1] * s, cols[2] * s, cols[3] * s}; }
  Mat4 operator/(float s) const { return {cols[0] / s, cols[1] / s, cols[2] / s, cols[3] / s}; }
  Mat4 operator*(const Mat4& m) const {
    return {*this * m[0], *this * m[1], *this * m[2], *this * m[3]};
  }
  Vec4 operator*(const Vec4& v) const {
    return cols[0] * v.x + cols[1] * v.y + cols[2] * v.z + cols[3] * v.w;
  }
  /// Of a point.
  Vec3 operator*(const Vec3& point) const { return (*this * Vec4(point, 1.0f)).project(); }
  Mat4& operator+=(const Mat4& m) { return *this = *this + m; }
  Mat4& operator-=(const Mat4& m) { return *this = *this - m; }
  Mat4& operator*=(float s) { return *this = *this * s; }
  Mat4& operator*=(const Mat4& m) { return *this = *this * m; }
  Mat4& operator/=(float s) { return *this = *this / s; }
  bool operator==(const Mat4& m) const {
    return cols[0] == m[0] && cols[1] == m[1] && cols[2] == m[2] && cols[3] == m[3];
  }
  bool operator!=(const Mat4& m) const { return !(*this == m); }

  /// The transpose.
  Mat4 T() const {
    Mat4 m;
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r)
        m.cols[r][c] = cols[c][r];
    }
    return m;
  }

  float det() const {
    float sum = 0.0f;
    for (int c = 0; c < 4; ++c)
      sum += cols[c][0] * cofactor(c, 0);
    return sum;
  }

  /// By Cramer's rule; not finite if there is none.
  Mat4 inverse() const {
    Mat4 m;
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r)
        m.cols[r][c] = cofactor(c, r);
    }
    return m / det();
  }

  Vec4 cols[4];

 private:
  /// The determinant without one column and one row, with its sign.
  float cofactor(int column, int row) const {
    float m[3][3];
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r)
        m[c][r] = cols[c + (c >= column ? 1 : 0)][r + (r >= row ? 1 : 0)];
    }
    const float minor = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[1][0] * (m[0][1] * m[2][2] - m[0][2] * m[2][1]) +
                        m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]);
    return (column + row) % 2 == 0 ? minor : -minor;
  }
};

inline const Mat4 Mat4::I = Mat4();
inline const Mat4 Mat4::Zero = Mat4(Vec4(), Vec4(), Vec4(), Vec4());

inline Mat4 operator*(float s, const Mat4& m) {
  return m * s;
}
inline Mat4 outer(const Vec4& l, const Vec4& r) {
  return Mat4::outer(l, r);
}

inline std::ostream& operator<<(std::ostream& out, const Mat4& m) {
  return out << "{" << m[0] << "," << m[1] << "," << m[2] << "," << m[3] << "}";
}
