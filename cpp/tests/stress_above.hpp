// SPDX-License-Identifier: GPL-3.0-or-later
// Margin between the von Mises stress due to tractions and its upper bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/stress_bound.hpp"

namespace samcontact::operators {

struct Above {
  double lowest = 1.0;  // minimum of bound less stress, relative to the largest pressure
  double mean = 0.0;    // mean over all bounds, relative to the mean stress
};

/// For all cells of a grid; depths: mid-depths of its layers.
inline Above stress_above(const Grid& grid, const VolumeOperators& whole, const StressBound& bound,
                          const Tractions& loads) {
  const Field s = whole.stress(nullptr, &loads, 1.0);
  const double max_pressure = *std::max_element(loads.pressure.begin(), loads.pressure.end());
  const std::size_t cells = grid.volume_size();
  double sum = 0.0, sum_of_bounds = 0.0;
  Above above;
  bound.for_each_depth(
      loads, 1.0, {std::vector<std::array<double, 3>>(grid.nz)}, [&](int k, const double* blocks) {
        for (int i = 0; i < grid.nx; ++i) {
          for (int j = 0; j < grid.ny; ++j) {
            const std::size_t n = (static_cast<std::size_t>(k) * grid.nx + i) * grid.ny + j;
            const double xx = s[n], yy = s[cells + n], yz = s[2 * cells + n], xz = s[3 * cells + n],
                         xy = s[4 * cells + n];
            const double stress =
                std::sqrt(3 * (xx * xx + yy * yy + xx * yy + yz * yz + xz * xz + xy * xy));
            const double limit =
                blocks[static_cast<std::size_t>(i / bound.block()) * bound.blocks_y() +
                       j / bound.block()];
#pragma omp critical
            {
              above.lowest = std::min(above.lowest, (limit - stress) / max_pressure);
              sum += stress;
              sum_of_bounds += limit;
            }
          }
        }
      });
  above.mean = sum_of_bounds / sum;
  return above;
}

inline std::vector<double> middles(const Grid& grid) {
  std::vector<double> depths(grid.nz);
  for (int k = 0; k < grid.nz; ++k) depths[k] = (k + 0.5) * grid.dz;
  return depths;
}

}  // namespace samcontact::operators
