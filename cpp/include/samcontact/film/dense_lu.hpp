// SPDX-License-Identifier: GPL-3.0-or-later
// LU decomposition of the first columns of a dense matrix in single precision, and the products of
// its parts with vectors.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::film {

using Singles = std::vector<float, AlignedAllocator<float>>;

/// Numbers in the widest register.
constexpr int lanes = 16;

/// Memory that products of matrices reuse.
struct PackedBlocks {
  Singles left, right;
};

/// Part of a matrix, stored by columns.
struct DenseView {
  float* values;
  int rows, columns, stride;

  float* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * stride; }
  DenseView part(int top, int height, int side, int width) const {
    return {column(side) + top, height, width, stride};
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

/// Substitution with the unit lower, and the upper triangle of a square matrix.
void substitute_forward(const DenseView& lower, float* x);
void substitute_backward(const DenseView& upper, float* x);
/// x -= matrix y
void subtract_columns(const DenseView& matrix, const float* y, float* x);
/// x -= y matrix; the rows are a multiple of `lanes`.
void subtract_dots(const DenseView& matrix, const float* y, float* x);

}  // namespace samcontact::film
