// SPDX-License-Identifier: GPL-3.0-or-later
// Definition of the products in an anonymous namespace, for the instruction set of the file that
// includes it. No include guard: each file has its own.

#include <Eigen/Core>
#include <Eigen/LU>

#include "samcontact/film/dense_products.hpp"

namespace samcontact::film {
namespace {

using Vector = Eigen::Map<Eigen::VectorXf>;
using Known = Eigen::Map<const Eigen::VectorXf>;
using Matrix = Eigen::Map<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

Matrix mapped(const DenseView& part) {
  return {part.values, part.rows, part.columns, Eigen::OuterStride<>(part.stride)};
}

constexpr DenseProducts by_eigen{
    [](const DenseView& left, const DenseView& right, const DenseView& result) {
      mapped(result).noalias() -= mapped(left) * mapped(right);
    },
    [](const DenseView& lower, const DenseView& right) {
      auto solved = mapped(right);
      mapped(lower).triangularView<Eigen::UnitLower>().solveInPlace(solved);
    },
    [](const DenseView& matrix, const float* y, float* x) {
      Vector(x, matrix.rows).noalias() -= mapped(matrix) * Known(y, matrix.columns);
    },
    [](const DenseView& matrix, const float* y, float* x) {
      Vector(x, matrix.columns).noalias() -= mapped(matrix).transpose() * Known(y, matrix.rows);
    },
    [](const DenseView& lower, float* x) {
      Vector solved(x, lower.rows);
      mapped(lower).triangularView<Eigen::UnitLower>().solveInPlace(solved);
    },
    [](const DenseView& upper, float* x) {
      Vector solved(x, upper.rows);
      mapped(upper).triangularView<Eigen::Upper>().solveInPlace(solved);
    }};

}  // namespace
}  // namespace samcontact::film
