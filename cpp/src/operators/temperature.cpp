// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/temperature.hpp"

#include <utility>

namespace samcontact::operators {

Temperature::Temperature(const Grid& grid, const Heating& heating, std::span<const double> depths)
    : plane_(grid.surface_size()), convolution_(grid), kernels_(depths.size()) {
  if (!heating.is_on()) return;
  const Offsets offsets = Offsets::lattice(grid.dx, grid.dy, grid.nx, grid.ny);
  for (std::size_t d = 0; d < depths.size(); ++d) {
    auto parts = heat_temperature(heating, grid.dx, grid.dy, depths[d], offsets);
    for (int flip = 0; flip < 4; ++flip) {
      if (parts[flip].empty()) continue;
      kernels_[d].push_back({{(flip & 1) != 0, (flip & 2) != 0, false}, std::move(parts[flip])});
      convolution_.transform(kernels_[d].back());
    }
  }
}

Field Temperature::rise(const double* pressure) const {
  Field rise(kernels_.size() * plane_, 0.0);
  ComplexField work;
  for (std::size_t d = 0; d < kernels_.size(); ++d) {
    if (!kernels_[d].empty()) {
      convolution_.apply(kernels_[d], pressure, rise.data() + d * plane_, work);
    }
  }
  return rise;
}

std::size_t Temperature::bytes() const {
  std::size_t values = 0;
  for (const auto& depth : kernels_) {
    for (const ParityKernel& kernel : depth) values += kernel.quarter.size();
  }
  return values * sizeof(double);
}

}  // namespace samcontact::operators
