// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of influence coefficients over the lattice of periodic images, without the box itself.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/layer_differences.hpp"

namespace samcontact::operators {

/// The lattice of images in units of coarse cells along x: a period is 2 cx by 2 cy cells.
struct ImageLattice {
  int cx, cy;
  double aspect;         // of a coarse cell
  int rings_x, rings_y;  // that are summed one by one

  /// The same with a wider square.
  ImageLattice wider() const { return {cx, cy, aspect, 2 * rings_x, 2 * rings_y}; }
  CornerLattice corners() const { return {(rings_x + 1) * 2 * cx, (rings_y + 1) * 2 * cy, aspect}; }
  /// Half widths of the square of summed images.
  double width_x() const { return (rings_x + 0.5) * 2 * cx; }
  double width_y() const { return (rings_y + 0.5) * 2 * cy * aspect; }

  /// Sum over the images of a kernel at offset (i, j) of coarse cells, from its values at
  /// non-negative offsets in rows of nx.
  double sum(const double* quarter, int nx, kernels::Parity parity, int i, int j) const {
    double total = 0.0;
    for (int n = -rings_y; n <= rings_y; ++n) {
      const int y = j + 2 * cy * n;
      for (int m = -rings_x; m <= rings_x; ++m) {
        if (m == 0 && n == 0) continue;
        const int x = i + 2 * cx * m;
        const bool negative = (parity.odd_x && x < 0) != (parity.odd_y && y < 0);
        const double value = quarter[static_cast<std::size_t>(std::abs(y)) * nx + std::abs(x)];
        total += negative ? -value : value;
      }
    }
    return total;
  }
};

/// Corner sums of a plate of half widths wx, wy at offset x, y, between two depths.
template <std::size_t N, class Corner>
std::array<double, N> plate(const Corner& corner, double x, double y, double wx, double wy,
                            double upper, double lower) {
  std::array<double, N> total{};
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      for (const double level : {upper, lower}) {
        const auto f = corner(x + sx * wx, y + sy * wy, level);
        const double sign = sx * sy * (level == lower ? 1.0 : -1.0);
        for (std::size_t m = 0; m < N; ++m) total[m] += sign * f[m];
      }
    }
  }
  return total;
}

/// Lattice sums [depth][kernel][y offset][x offset] of N kernels. The images beyond the summed
/// rings count as a uniform plate with a square hole (midpoint rule); its error falls with the cube
/// of the hole's width, and two widths extrapolate it.
template <std::size_t N, class Level, class Corner, class ParityOf>
Field lattice_sums(const ImageLattice& near, int depths, const Level& level, const Corner& corner,
                   const ParityOf& parity) {
  const ImageLattice wide = near.wider();
  const CornerLattice lattice = wide.corners();
  const int cx = near.cx, cy = near.cy;
  const std::size_t offsets = static_cast<std::size_t>(2 * cx - 1) * (2 * cy - 1);
  const double density = 1.0 / (4.0 * cx * cy);
  const double gain = std::pow(wide.width_x() / near.width_x(), 3) - 1;
  constexpr double endless = 1e7;
  Field sums(depths * N * offsets);
  for_each_layer_difference<N>(lattice, depths, level, corner, [&](int n, const double* values) {
    Field quarter(static_cast<std::size_t>(lattice.nx) * lattice.ny);
    std::vector<std::array<double, N>> near_tail, wide_tail;
    for (int j = 0; j < cy; ++j) {
      for (int i = 0; i < cx; ++i) {
        const auto outside = [&](const ImageLattice& hole) {
          const double x = i, y = j * near.aspect, upper = level(n), lower = level(n + 1);
          auto tail = plate<N>(corner, x, y, endless, endless * near.aspect, upper, lower);
          const auto inside = plate<N>(corner, x, y, hole.width_x(), hole.width_y(), upper, lower);
          for (std::size_t m = 0; m < N; ++m) tail[m] = density * (tail[m] - inside[m]);
          return tail;
        };
        near_tail.push_back(outside(near));
        wide_tail.push_back(outside(wide));
      }
    }
    for (std::size_t m = 0; m < N; ++m) {
      lattice.corner_sums(values + m * lattice.size(), quarter.data(), lattice.nx, lattice.ny);
      const kernels::Parity p = parity(static_cast<int>(m));
      double* to = sums.data() + (n * N + m) * offsets;
      for (int j = 0; j < cy; ++j) {
        for (int i = 0; i < cx; ++i) {
          const std::size_t at = static_cast<std::size_t>(j) * cx + i;
          const double few = near.sum(quarter.data(), lattice.nx, p, i, j) + near_tail[at][m];
          const double many = wide.sum(quarter.data(), lattice.nx, p, i, j) + wide_tail[at][m];
          const double sum = many + (many - few) / gain;
          for (const int sj : {-1, 1}) {
            for (const int si : {-1, 1}) {
              const bool negative = (p.odd_x && si < 0) != (p.odd_y && sj < 0);
              to[(cy - 1 + sj * j) * (2 * cx - 1) + cx - 1 + si * i] = negative ? -sum : sum;
            }
          }
        }
      }
    }
  });
  return sums;
}

}  // namespace samcontact::operators
