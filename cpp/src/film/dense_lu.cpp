// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "samcontact/base/multiversion.hpp"

namespace samcontact::film {
namespace {

/// Columns that are eliminated one by one.
constexpr int narrow = 8;
/// A pivot on the diagonal is taken if it is larger than this share of the column, and replaced if
/// it is smaller than this share of the rows, whose largest coefficients are near one.
constexpr float pivot_share = 0.01F, least_pivot = 1e-6F;

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
  Elimination(const DenseView& matrix, const char* free, std::vector<int>& pivots)
      : matrix_(matrix), free_(free), pivots_(pivots) {}

  /// Decomposes the columns [first, end) from row `first` on.
  bool decompose(int first, int end) const {
    if (end - first <= narrow) return decompose_narrow(first, end);
    const int middle = (first + end) / 2, done = middle - first, rest = end - middle;
    if (!decompose(first, middle)) return false;
    exchange_rows(all_rows(middle, rest), pivots_, first, middle);
    const DenseView across = matrix_.part(first, done, middle, rest);
    const int below = matrix_.rows - middle;
    products_.solve_lower(matrix_.part(first, done, first, done), across);
    products_.subtract_product(matrix_.part(middle, below, first, done), across,
                               matrix_.part(middle, below, middle, rest));
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
  const DenseProducts& products_ = dense_products();
};

}  // namespace

bool eliminate(const DenseView& matrix, const char* free, std::vector<int>& pivots) {
  const DenseProducts& products = dense_products();
  const int count = static_cast<int>(pivots.size());
  if (!Elimination(matrix, free, pivots).decompose(0, count)) return false;
  const int rest = matrix.rows - count;
  if (rest == 0) return true;
  const DenseView right = matrix.part(0, count, count, rest);
  exchange_rows(right, pivots, 0, count);
  products.solve_lower(matrix.part(0, count, 0, count), right);
  products.subtract_product(matrix.part(count, rest, 0, count), right,
                            matrix.part(count, rest, count, rest));
  return true;
}

}  // namespace samcontact::film
