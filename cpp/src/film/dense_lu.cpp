// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "samcontact/base/multiversion.hpp"

namespace samcontact::film {
namespace {

/// Rows and columns of a tile, whose sums stay in registers of all instruction sets.
constexpr int tile_rows = lanes, tile_columns = 6;
/// Rows and depth of a block that stays in the cache.
constexpr int block_rows = 192, block_depth = 256;
/// Columns that are eliminated one by one.
constexpr int narrow = 8;
/// Distance of the numbers that are fetched before they are needed: columns are too short for the
/// processor to do so.
constexpr int ahead = 256;
/// A pivot on the diagonal is taken if it is larger than this share of the column, and replaced if
/// it is smaller than this share of the rows, whose largest coefficients are near one.
constexpr float pivot_share = 0.01F, least_pivot = 1e-6F;

using Lanes [[gnu::vector_size(tile_rows * sizeof(float)), gnu::may_alias]] = float;
using Loose [[gnu::vector_size(tile_rows * sizeof(float)), gnu::may_alias, gnu::aligned(4)]] =
    float;

int groups(int count, int width) { return (count + width - 1) / width; }

/// Copies a part to strips of as many rows, or columns, as a tile has, filled up by zeros.
void pack_rows(const DenseView& from, Singles& to) {
  to.resize(static_cast<std::size_t>(groups(from.rows, tile_rows)) * tile_rows * from.columns);
  float* next = to.data();
  for (int i = 0; i < from.rows; i += tile_rows) {
    const int rows = std::min(tile_rows, from.rows - i);
    for (int k = 0; k < from.columns; ++k, next += tile_rows) {
      std::copy_n(from.column(k) + i, rows, next);
      std::fill(next + rows, next + tile_rows, 0.0F);
    }
  }
}

void pack_columns(const DenseView& from, Singles& to) {
  to.resize(static_cast<std::size_t>(groups(from.columns, tile_columns)) * tile_columns *
            from.rows);
  const std::ptrdiff_t strip = static_cast<std::ptrdiff_t>(tile_columns) * from.rows;
  float* next = to.data();
  for (int j = 0; j < from.columns; j += tile_columns, next += strip) {
    for (int b = 0; b < tile_columns; ++b) {
      const float* column = j + b < from.columns ? from.column(j + b) : nullptr;
      for (int k = 0; k < from.rows; ++k) {
        next[k * tile_columns + b] = column != nullptr ? column[k] : 0.0F;
      }
    }
  }
}

/// Subtracts the product of packed strips from a tile of the result.
SAMCONTACT_MULTIVERSION
void subtract_tiles(const float* left, const float* right, int depth, const DenseView& result) {
  for (int j = 0; j < result.columns; j += tile_columns) {
    const float* strip = right + static_cast<std::ptrdiff_t>(j) * depth;
    const int columns = std::min(tile_columns, result.columns - j);
    for (int i = 0; i < result.rows; i += tile_rows) {
      const float* a = left + static_cast<std::ptrdiff_t>(i) * depth;
      const float* b = strip;
      Lanes sums[tile_columns] = {};
      for (int k = 0; k < depth; ++k, a += tile_rows, b += tile_columns) {
        const Lanes column = *reinterpret_cast<const Loose*>(a);
        for (int c = 0; c < tile_columns; ++c) sums[c] += column * b[c];
      }
      const int rows = std::min(tile_rows, result.rows - i);
      for (int c = 0; c < columns; ++c) {
        float* out = result.column(j + c) + i;
        if (rows == tile_rows) {
          *reinterpret_cast<Loose*>(out) -= sums[c];
        } else {
          for (int r = 0; r < rows; ++r) out[r] -= sums[c][r];
        }
      }
    }
  }
}

/// Subtracts from each column of a part a multiple of a column; the factors are a row.
SAMCONTACT_MULTIVERSION
void subtract_column(const float* column, const DenseView& part, const float* factors) {
  for (int j = 0; j < part.columns; ++j) {
    float* next = part.column(j);
    const float factor = factors[static_cast<std::ptrdiff_t>(j) * part.stride];
#pragma omp simd
    for (int i = 0; i < part.rows; ++i) next[i] -= factor * column[i];
  }
}

/// right = L^-1 right with the unit lower triangle of a square part.
void solve_lower(const DenseView& lower, const DenseView& right, PackedBlocks& blocks) {
  const int n = lower.columns;
  if (n <= narrow) {
    for (int k = 0; k + 1 < n; ++k) {
      subtract_column(lower.column(k) + k + 1, right.part(k + 1, n - k - 1, 0, right.columns),
                      right.values + k);
    }
    return;
  }
  const int half = n / 2;
  const DenseView top = right.part(0, half, 0, right.columns);
  const DenseView bottom = right.part(half, n - half, 0, right.columns);
  solve_lower(lower.part(0, half, 0, half), top, blocks);
  subtract_product(lower.part(half, n - half, 0, half), top, bottom, blocks);
  solve_lower(lower.part(half, n - half, half, n - half), bottom, blocks);
}

void exchange_rows(const DenseView& part, const std::vector<int>& pivots, int first, int end) {
  for (int i = first; i < end; ++i) {
    if (pivots[i] == i) continue;
    for (int j = 0; j < part.columns; ++j) {
      std::swap(part.column(j)[i], part.column(j)[pivots[i]]);
    }
  }
}

/// Eliminates columns of a matrix, by halves.
class Elimination {
 public:
  Elimination(const DenseView& matrix, const char* free, std::vector<int>& pivots,
              PackedBlocks& blocks)
      : matrix_(matrix), free_(free), pivots_(pivots), blocks_(blocks) {}

  /// Decomposes the columns [first, end) from row `first` on.
  bool decompose(int first, int end) const {
    if (end - first <= narrow) return decompose_narrow(first, end);
    const int middle = (first + end) / 2, done = middle - first, rest = end - middle;
    if (!decompose(first, middle)) return false;
    exchange_rows(all_rows(middle, rest), pivots_, first, middle);
    const DenseView across = matrix_.part(first, done, middle, rest);
    const int below = matrix_.rows - middle;
    solve_lower(matrix_.part(first, done, first, done), across, blocks_);
    subtract_product(matrix_.part(middle, below, first, done), across,
                     matrix_.part(middle, below, middle, rest), blocks_);
    if (!decompose(middle, end)) return false;
    exchange_rows(all_rows(first, done), pivots_, middle, end);
    return true;
  }

 private:
  DenseView all_rows(int first, int columns) const {
    return matrix_.part(0, matrix_.rows, first, columns);
  }
  int pivot_of(int k) const {
    if (!free_[k]) return k;
    const float* column = matrix_.column(k);
    int largest = k;
    for (int i = k + 1; i < std::ssize(pivots_); ++i) {
      if (free_[i] && std::fabs(column[i]) > std::fabs(column[largest])) largest = i;
    }
    return std::fabs(column[k]) < pivot_share * std::fabs(column[largest]) ? largest : k;
  }
  bool decompose_narrow(int first, int end) const {
    for (int k = first; k < end; ++k) {
      pivots_[k] = pivot_of(k);
      exchange_rows(all_rows(first, end - first), pivots_, k, k + 1);
      float* column = matrix_.column(k);
      if (free_[k] && std::fabs(column[k]) < least_pivot) {
        column[k] = std::copysign(least_pivot, column[k]);
      }
      const float inverse = 1 / column[k];
      if (!std::isfinite(inverse)) return false;
      for (int i = k + 1; i < matrix_.rows; ++i) column[i] *= inverse;
      if (k + 1 == end) break;
      const DenseView rest = matrix_.part(k + 1, matrix_.rows - k - 1, k + 1, end - k - 1);
      subtract_column(column + k + 1, rest, rest.values - 1);
    }
    return true;
  }

  const DenseView& matrix_;
  const char* free_;
  std::vector<int>& pivots_;
  PackedBlocks& blocks_;
};

}  // namespace

void subtract_product(const DenseView& left, const DenseView& right, const DenseView& result,
                      PackedBlocks& blocks) {
  for (int k = 0; k < left.columns; k += block_depth) {
    const int depth = std::min(block_depth, left.columns - k);
    pack_columns(right.part(k, depth, 0, right.columns), blocks.right);
    for (int i = 0; i < left.rows; i += block_rows) {
      const int rows = std::min(block_rows, left.rows - i);
      pack_rows(left.part(i, rows, k, depth), blocks.left);
      subtract_tiles(blocks.left.data(), blocks.right.data(), depth,
                     result.part(i, rows, 0, result.columns));
    }
  }
}

bool eliminate(const DenseView& matrix, const char* free, std::vector<int>& pivots,
               PackedBlocks& blocks) {
  const int count = static_cast<int>(pivots.size());
  if (!Elimination(matrix, free, pivots, blocks).decompose(0, count)) return false;
  const int rest = matrix.rows - count;
  if (rest == 0) return true;
  const DenseView right = matrix.part(0, count, count, rest);
  exchange_rows(right, pivots, 0, count);
  solve_lower(matrix.part(0, count, 0, count), right, blocks);
  subtract_product(matrix.part(count, rest, 0, count), right, matrix.part(count, rest, count, rest),
                   blocks);
  return true;
}

void substitute_forward(const DenseView& lower, float* x) {
  for (int first = 0; first < lower.columns; first += narrow) {
    const int end = std::min(first + narrow, lower.columns);
    for (int j = first; j < end; ++j) {
      for (int i = j + 1; i < end; ++i) x[i] -= x[j] * lower.column(j)[i];
    }
    subtract_columns(lower.part(end, lower.rows - end, first, end - first), x + first, x + end);
  }
}

void substitute_backward(const DenseView& upper, float* x) {
  for (int end = upper.columns; end > 0; end -= narrow) {
    const int first = std::max(end - narrow, 0);
    for (int j = end - 1; j >= first; --j) {
      x[j] /= upper.column(j)[j];
      for (int i = first; i < j; ++i) x[i] -= x[j] * upper.column(j)[i];
    }
    subtract_columns(upper.part(0, first, first, end - first), x + first, x);
  }
}

SAMCONTACT_MULTIVERSION
void subtract_columns(const DenseView& matrix, const float* y, float* x) {
  for (int j = 0; j < matrix.columns; ++j) {
    const float* column = matrix.column(j);
    const float factor = y[j];
#pragma omp simd
    for (int i = 0; i < matrix.rows; ++i) x[i] -= factor * column[i];
    for (int i = 0; i < matrix.rows; i += lanes) __builtin_prefetch(column + i + ahead);
  }
}

SAMCONTACT_MULTIVERSION
void subtract_dots(const DenseView& matrix, const float* y, float* x) {
  for (int j = 0; j < matrix.columns; ++j) {
    const float* column = matrix.column(j);
    Lanes sums[2] = {};  // so that an addition need not wait for the last one
    int i = 0;
    for (; i + lanes < matrix.rows; i += 2 * lanes) {
      sums[0] +=
          *reinterpret_cast<const Loose*>(y + i) * *reinterpret_cast<const Loose*>(column + i);
      sums[1] += *reinterpret_cast<const Loose*>(y + i + lanes) *
                 *reinterpret_cast<const Loose*>(column + i + lanes);
      __builtin_prefetch(column + i + ahead);
      __builtin_prefetch(column + i + ahead + lanes);
    }
    if (i < matrix.rows) {
      sums[0] +=
          *reinterpret_cast<const Loose*>(y + i) * *reinterpret_cast<const Loose*>(column + i);
      __builtin_prefetch(column + i + ahead);
    }
    sums[0] += sums[1];
    for (int r = 0; r < lanes; ++r) x[j] -= sums[0][r];
  }
}

}  // namespace samcontact::film
