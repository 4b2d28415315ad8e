// SPDX-License-Identifier: GPL-3.0-or-later
// LU decomposition of the first columns of a dense matrix in single precision, and the products of
// its parts with vectors.
#pragma once

#include <cstddef>
#include <vector>

namespace samcontact::film {

/// Memory that products of matrices reuse.
struct PackedBlocks {
  std::vector<float> left, right;
};

/// Part of a matrix, stored by columns.
struct DenseView {
  float* values;
  int rows, columns, stride;

  float* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * stride; }
  DenseView part(int row, int rows_, int first, int columns_) const {
    return {column(first) + row, rows_, columns_, stride};
  }
};

/// result -= left * right
void subtract_product(const DenseView& left, const DenseView& right, const DenseView& result,
                      PackedBlocks& blocks);

/// Eliminates the first columns of a square matrix, as many as there are pivots: L and U are in
/// place of these columns and rows, the Schur complement in place of the rest. Pivots are on the
/// diagonal as far as possible; the first rows that are free may exchange places, if their largest
/// coefficients are near one. pivots: becomes the row that each row is exchanged with. Returns
/// whether the pivots of the other rows differ from zero.
bool eliminate(const DenseView& matrix, const char* free, std::vector<int>& pivots,
               PackedBlocks& blocks);

/// Forward substitution with the unit lower triangle of the first columns, all rows: x[0..columns)
/// becomes the solution, and the rest is reduced by its product.
void substitute_forward(const DenseView& lower, float* x);
/// x -= matrix y
void subtract_product(const DenseView& matrix, const float* y, float* x);
/// Backward substitution with the upper triangle of a square matrix.
void substitute_backward(const DenseView& upper, float* x);

}  // namespace samcontact::film
