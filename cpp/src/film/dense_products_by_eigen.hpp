// SPDX-License-Identifier: GPL-3.0-or-later
// Definition of the products, compiled for the instruction set of the file that includes it.
#pragma once

#include <Eigen/Core>

#include "samcontact/film/dense_products.hpp"

namespace samcontact::film {

/// Version: a type for each instruction set, so that the linker keeps their functions apart.
template <class Version>
struct ByEigen {
  using Vector = Eigen::Map<Eigen::VectorXf>;
  using Known = Eigen::Map<const Eigen::VectorXf>;
  using Matrix = Eigen::Map<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

  static Matrix mapped(const DenseView& part) {
    return {part.values, part.rows, part.columns, Eigen::OuterStride<>(part.stride)};
  }
  static void subtract_product(const DenseView& left, const DenseView& right,
                               const DenseView& result) {
    mapped(result).noalias() -= mapped(left) * mapped(right);
  }
  static void solve_lower(const DenseView& lower, const DenseView& right) {
    const Matrix solved = mapped(right);
    mapped(lower).template triangularView<Eigen::UnitLower>().solveInPlace(solved);
  }
  static void subtract_columns(const DenseView& matrix, const float* y, float* x) {
    Vector(x, matrix.rows).noalias() -= mapped(matrix) * Known(y, matrix.columns);
  }
  static void subtract_dots(const DenseView& matrix, const float* y, float* x) {
    Vector(x, matrix.columns).noalias() -= mapped(matrix).transpose() * Known(y, matrix.rows);
  }
  static void substitute_forward(const DenseView& lower, float* x) {
    const Vector solved(x, lower.rows);
    mapped(lower).template triangularView<Eigen::UnitLower>().solveInPlace(solved);
  }
  static void substitute_backward(const DenseView& upper, float* x) {
    const Vector solved(x, upper.rows);
    mapped(upper).template triangularView<Eigen::Upper>().solveInPlace(solved);
  }
  static constexpr DenseProducts products{&subtract_product,   &solve_lower,
                                          &subtract_columns,   &subtract_dots,
                                          &substitute_forward, &substitute_backward};
};

}  // namespace samcontact::film
