// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over rings in wavenumber: products of matrices, and phases at equidistant offsets.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/kernels/ring_axis.hpp"
#include "samcontact/kernels/ring_product.hpp"

using namespace samcontact::kernels;

TEST_CASE("the product of three matrices is right for sizes that fill no register") {
  const int rows = 13, inner = 7, across = 9, columns = 11;
  const auto numbers = [](int count, double seed) {
    std::vector<double> values(count);
    for (int n = 0; n < count; ++n) values[n] = std::sin(seed + 1.3 * n);
    return values;
  };
  const auto left = numbers(rows * inner, 0.1), middle = numbers(inner * across, 0.7),
             right = numbers(columns * across, 2.0);
  std::vector<double> result(rows * columns);
  ring_product({left.data(), middle.data(), right.data(), rows, inner, across, columns},
               result.data());
  double largest = 0.0;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      double sum = 0.0;
      for (int m = 0; m < inner; ++m) {
        for (int n = 0; n < across; ++n) {
          sum += left[m * rows + i] * middle[n * inner + m] * right[n * columns + j];
        }
      }
      largest = std::max(largest, std::fabs(result[j * rows + i] - sum));
    }
  }
  CHECK(largest < 1e-13);
}

TEST_CASE("phases do not depend on the order of the offsets") {
  std::vector<double> offsets(150);
  for (std::size_t n = 0; n < offsets.size(); ++n) offsets[n] = 0.37 * static_cast<double>(n);
  std::vector<double> mixed = offsets;
  for (std::size_t n = 0; n < mixed.size(); n += 2) std::swap(mixed[n], mixed[n + 1]);
  const ring::Axis ascending(offsets, 0.37, 100.0, 2.5, false),
      other(mixed, 0.37, 100.0, 2.5, false);
  REQUIRE(ascending.k == other.k);
  double largest = 0.0;
  for (std::size_t n = 0; n < mixed.size(); ++n) {
    const auto at = std::ranges::find(offsets, mixed[n]) - offsets.begin();
    const auto row = static_cast<Eigen::Index>(n);
    largest =
        std::max({largest, (ascending.even.row(at) - other.even.row(row)).cwiseAbs().maxCoeff(),
                  (ascending.odd.row(at) - other.odd.row(row)).cwiseAbs().maxCoeff()});
  }
  CHECK(largest < 1e-12 * other.even.cwiseAbs().maxCoeff());
}
