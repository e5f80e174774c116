#pragma once

#include "matrix.h"

namespace meshedit {

/// Begins as the identity.
class Matrix3x3 : public SquareMatrix<Matrix3x3, Vector3D, 3> {
 public:
  Matrix3x3() {
    for (int i = 0; i < 3; ++i)
      (*this)(i, i) = 1.0;
  }
  explicit Matrix3x3(const double* data) : SquareMatrix(data) {}
  /// Row by row.
  Matrix3x3(double a, double b, double c, double d, double e, double f, double g, double h,
            double i)
      : SquareMatrix(std::array<double, 9>{a, b, c, d, e, f, g, h, i}.data()) {}

  /// The matrix M for which M x = cross(u, x).
  static Matrix3x3 crossProduct(const Vector3D& u) {
    return {0.0, -u.z, u.y, u.z, 0.0, -u.x, -u.y, u.x, 0.0};
  }
};

/// Entry (i, j) is u[i] v[j].
inline Matrix3x3 outer(const Vector3D& u, const Vector3D& v) {
  Matrix3x3 matrix;
  for (int i = 0; i < 9; ++i)
    matrix(i / 3, i % 3) = u[i / 3] * v[i % 3];
  return matrix;
}

}  // namespace meshedit
