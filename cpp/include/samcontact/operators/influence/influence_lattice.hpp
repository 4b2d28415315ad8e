// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of all cells of a grid from one evaluation per cell corner: neighbouring
// cells share their corners.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "samcontact/base/aligned.hpp"

namespace samcontact::operators {

/// Corners of the cells at offsets 0..nx-1, 0..ny-1: x = (i - 1/2), y = (j - 1/2) aspect in units
/// of dx, aspect = dy/dx.
struct CornerLattice {
  int nx, ny;
  double aspect;

  std::size_t size() const { return static_cast<std::size_t>(nx + 1) * (ny + 1); }

  /// values[m size() + j (nx + 1) + i] = corner(x_i, y_j)[m]. exchanged: index of each function
  /// after x and y are exchanged; half of the values of square cells then follow from the others.
  template <std::size_t N, class Corner>
  void evaluate(const Corner& corner, double* values,
                const std::array<std::size_t, N>* exchanged = nullptr) const {
    const auto place = [this](int i, int j) { return static_cast<std::size_t>(j) * (nx + 1) + i; };
    const int known = exchanged != nullptr && aspect == 1 ? nx : -1;  // last row with such values
    for (int j = 0; j <= ny; ++j) {
      for (int i = j <= known ? j : 0; i <= nx; ++i) {
        const std::array<double, N> f = corner(i - 0.5, (j - 0.5) * aspect);
        for (std::size_t m = 0; m < N; ++m) values[m * size() + place(i, j)] = f[m];
      }
    }
    for (int j = 1; j <= std::min(known, ny); ++j) {
      for (int i = 0; i < j; ++i) {
        for (std::size_t m = 0; m < N; ++m) {
          values[m * size() + place(i, j)] = values[(*exchanged)[m] * size() + place(j, i)];
        }
      }
    }
  }

  /// quarter[j hx + i] = sum of the corners of cell (i, j); beyond the last offset 0.
  void corner_sums(const double* values, double* quarter, int hx, int hy) const;
};

}  // namespace samcontact::operators
