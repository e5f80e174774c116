#pragma once

// Matrix3x3 and Matrix4x4 are used alike: one class for both.

#include <array>
#include <cmath>
#include <ostream>
#include <utility>

#include "meshedit/vector3d.h"

namespace meshedit {

/// A square matrix of columns. It begins as `N` zero columns.
template <class Self, class Column, int N>
class SquareMatrix {
 public:
  SquareMatrix() = default;
  /// Row by row.
  explicit SquareMatrix(const double* data) {
    for (int i = 0; i < N * N; ++i)
      (*this)(i / N, i % N) = data[i];
  }

  double& operator()(int row, int column) { return entries[at(column)][row]; }
  const double& operator()(int row, int column) const { return entries[at(column)][row]; }
  Column& operator[](int i) { return entries[at(i)]; }
  const Column& operator[](int i) const { return entries[at(i)]; }
  Column& column(int i) { return entries[at(i)]; }
  const Column& column(int i) const { return entries[at(i)]; }

  static Self identity() {
    Self matrix;
    matrix.zero();
    for (int i = 0; i < N; ++i)
      matrix(i, i) = 1.0;
    return matrix;
  }

  /// Sets all entries.
  void zero(double value = 0.0) {
    for_each([&](int i, int j) { (*this)(i, j) = value; });
  }

  /// The square root of the sum of the squares of all entries.
  double norm() const {
    double sum = 0.0;
    for_each([&](int i, int j) { sum += (*this)(i, j) * (*this)(i, j); });
    return std::sqrt(sum);
  }

  double det() const { return Elimination(*this).determinant; }
  /// NaN or infinite where there is none.
  Self inv() const { return Elimination(*this).inverse; }

  Self T() const {
    return made([&](int i, int j) { return (*this)(j, i); });
  }
  Self operator-() const {
    return made([&](int i, int j) { return -(*this)(i, j); });
  }
  Self operator-(const Self& b) const {
    return made([&](int i, int j) { return (*this)(i, j) - b(i, j); });
  }
  Self operator+(const Self& b) const {
    return made([&](int i, int j) { return (*this)(i, j) + b(i, j); });
  }
  Self operator*(double c) const {
    return made([&](int i, int j) { return (*this)(i, j) * c; });
  }
  friend Self operator*(double c, const Self& a) { return a * c; }
  Self operator*(const Self& b) const {
    return made([&](int i, int j) {
      double sum = 0.0;
      for (int k = 0; k < N; ++k)
        sum += (*this)(i, k) * b(k, j);
      return sum;
    });
  }
  Column operator*(const Column& x) const {
    Column sum;
    for (int k = 0; k < N; ++k)
      sum += entries[at(k)] * x[k];
    return sum;
  }
  void operator+=(const Self& b) {
    for_each([&](int i, int j) { (*this)(i, j) += b(i, j); });
  }
  void operator/=(double c) {
    for_each([&](int i, int j) { (*this)(i, j) /= c; });
  }

  friend std::ostream& operator<<(std::ostream& out, const Self& a) {
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j)
        out << (j == 0 ? "[ " : " ") << a(i, j);
      out << " ]\n";
    }
    return out;
  }

 protected:
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  template <class Visit>
  static void for_each(Visit visit) {
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j)
        visit(i, j);
    }
  }

  template <class Entry>
  static Self made(Entry entry) {
    Self matrix;
    for_each([&](int i, int j) { matrix(i, j) = entry(i, j); });
    return matrix;
  }

  std::array<Column, static_cast<std::size_t>(N)> entries;

 private:
  /// Gauss and Jordan's, with the largest pivot of each column.
  struct Elimination {
    explicit Elimination(const SquareMatrix& matrix) : left(matrix) {
      for (int c = 0; c < N; ++c) {
        int pivot = c;
        for (int r = c + 1; r < N; ++r) {
          if (std::abs(left(r, c)) > std::abs(left(pivot, c))) pivot = r;
        }
        if (pivot != c) swap_rows(pivot, c);
        clear_column(c);
      }
    }

    void swap_rows(int a, int b) {
      determinant = -determinant;
      for (int j = 0; j < N; ++j) {
        std::swap(left(a, j), left(b, j));
        std::swap(inverse(a, j), inverse(b, j));
      }
    }

    void clear_column(int c) {
      const double divisor = left(c, c);
      determinant *= divisor;
      for (int j = 0; j < N; ++j) {
        left(c, j) /= divisor;
        inverse(c, j) /= divisor;
      }
      for (int r = 0; r < N; ++r) {
        const double factor = left(r, c);
        for (int j = 0; r != c && j < N; ++j) {
          left(r, j) -= factor * left(c, j);
          inverse(r, j) -= factor * inverse(c, j);
        }
      }
    }

    SquareMatrix left;
    Self inverse = Self::identity();
    double determinant = 1.0;
  };
};

}  // namespace meshedit
