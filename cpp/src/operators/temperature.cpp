// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/temperature.hpp"

#include <vector>

#include "samcontact/operators/surface_convolution.hpp"

namespace samcontact::operators {

Field temperature(const Grid& grid, const Heating& heating, std::span<const double> depths,
                  const double* pressure) {
  const std::size_t plane = grid.surface_size();
  Field rise(depths.size() * plane, 0.0);
  if (!heating.is_on()) return rise;
  const SurfaceConvolution convolution(grid);
  const Offsets offsets = Offsets::lattice(grid.dx, grid.dy, grid.nx, grid.ny);
  ComplexField work;
  for (std::size_t d = 0; d < depths.size(); ++d) {
    auto parts = heat_temperature(heating, grid.dx, grid.dy, depths[d], offsets);
    std::vector<ParityKernel> kernels;
    for (int flip = 0; flip < 4; ++flip) {
      if (parts[flip].empty()) continue;
      kernels.push_back({{(flip & 1) != 0, (flip & 2) != 0, false}, std::move(parts[flip])});
      convolution.transform(kernels.back());
    }
    convolution.apply(kernels, pressure, rise.data() + d * plane, work);
  }
  return rise;
}

}  // namespace samcontact::operators
