#pragma once

#include "matrix.h"
#include "vector4D.h"

namespace meshedit {

/// Begins as zero.
class Matrix4x4 : public SquareMatrix<Matrix4x4, Vector4D, 4> {
 public:
  Matrix4x4() = default;
  explicit Matrix4x4(const double* data) : SquareMatrix(data) {}
};

/// Entry (i, j) is u[i] v[j].
inline Matrix4x4 outer(const Vector4D& u, const Vector4D& v) {
  Matrix4x4 matrix;
  for (int i = 0; i < 16; ++i)
    matrix(i / 4, i % 4) = u[i / 4] * v[i % 4];
  return matrix;
}

}  // namespace meshedit
