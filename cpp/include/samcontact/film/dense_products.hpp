// SPDX-License-Identifier: GPL-3.0-or-later
// Products and triangular solves of dense matrices in single precision by Eigen, compiled for
// several instruction sets, one of which is chosen at run time.
#pragma once

#include <cstddef>

namespace samcontact::film {

/// Part of a matrix, stored by columns.
struct DenseView {
  float* values;
  int rows, columns, stride;

  float* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * stride; }
  DenseView part(int top, int height, int side, int width) const {
    return {column(side) + top, height, width, stride};
  }
};

/// Functions of one instruction set.
struct DenseProducts {
  /// result -= left * right
  void (*subtract_product)(const DenseView& left, const DenseView& right, const DenseView& result);
  /// right = L^-1 right with the unit lower triangle of a square part.
  void (*solve_lower)(const DenseView& lower, const DenseView& right);
  /// x -= matrix y
  void (*subtract_columns)(const DenseView& matrix, const float* y, float* x);
  /// x -= y matrix
  void (*subtract_dots)(const DenseView& matrix, const float* y, float* x);
  /// Substitution with the unit lower, and the upper triangle of a square matrix.
  void (*substitute_forward)(const DenseView& lower, float* x);
  void (*substitute_backward)(const DenseView& upper, float* x);
};

/// Products by the widest instructions of this processor.
const DenseProducts& dense_products();
/// Products for x86 processors with AVX2 and FMA; only if the compiler supports several versions.
const DenseProducts& dense_products_by_avx();

}  // namespace samcontact::film
