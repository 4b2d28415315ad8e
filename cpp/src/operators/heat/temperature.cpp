// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/temperature.hpp"

#include <utility>

#include "samcontact/operators/heat/layered_heat.hpp"

namespace samcontact::operators {

Temperature::Temperature(const Grid& grid, Heating heating)
    : grid_(grid), heating_(std::move(heating)), convolution_(grid) {}

std::shared_ptr<const Temperature::Kernels> Temperature::kernels(double depth) const {
  const std::lock_guard lock(mutex_);
  auto& kept = kept_[depth];
  if (kept) return kept;
  const auto [nx, ny] = convolution_.offsets();
  const Offsets offsets = Offsets::lattice(grid_.dx, grid_.dy, nx, ny);
  auto parts = layered_heat_temperature(heating_, grid_.dx, grid_.dy, depth, offsets);
  Kernels made;
  for (int flip = 0; flip < 4; ++flip) {
    if (parts[flip].empty()) continue;
    made.push_back({{(flip & 1) != 0, (flip & 2) != 0, false}, std::move(parts[flip])});
    convolution_.transform(made.back());
  }
  kept = std::make_shared<const Kernels>(std::move(made));
  return kept;
}

Field Temperature::rise(const double* pressure, std::span<const double> depths) const {
  const std::size_t plane = grid_.surface_size();
  Field rise(depths.size() * plane, 0.0);
  if (!heating_.is_on()) return rise;
  ComplexField work;
  for (std::size_t d = 0; d < depths.size(); ++d) {
    const auto here = kernels(depths[d]);
    if (!here->empty()) convolution_.apply(*here, pressure, rise.data() + d * plane, work);
  }
  return rise;
}

std::size_t Temperature::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t values = 0;
  for (const auto& [depth, kernels] : kept_) {
    if (!kernels) continue;
    for (const ParityKernel& kernel : *kernels) values += kernel.quarter.size();
  }
  return values * sizeof(double);
}

}  // namespace samcontact::operators
