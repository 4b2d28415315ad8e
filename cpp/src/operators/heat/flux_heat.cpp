// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/flux_heat.hpp"

#include <utility>

#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {
namespace {

/// Transformed parts of a kernel; parity: that for a source at rest.
std::vector<ParityKernel> kernels_of(ParityParts parts, kernels::Parity parity,
                                     const SurfaceConvolution& convolution) {
  std::vector<ParityKernel> made;
  for (int flip = 0; flip < 4; ++flip) {
    if (parts[flip].empty()) continue;
    made.push_back({{parity.odd_x != ((flip & 1) != 0), parity.odd_y != ((flip & 2) != 0), false},
                    std::move(parts[flip])});
    convolution.transform(made.back());
  }
  return made;
}

}  // namespace

FluxHeat::FluxHeat(const Grid& grid, SharedHeatMedium body, const Heating& heating)
    : grid_(grid),
      body_(std::move(body)),
      temperature_(grid, heating),
      stress_(grid, body_, heating),
      convolution_(grid) {}

Field FluxHeat::displacement(const Field& flux) const {
  const std::lock_guard lock(mutex_);
  if (displacement_.empty()) {
    const auto [nx, ny] = convolution_.offsets();
    const Offsets offsets = Offsets::lattice(grid_.dx, grid_.dy, nx, ny);
    displacement_ =
        kernels_of(body_->displacement(heating(), grid_.dx, grid_.dy, offsets), {}, convolution_);
  }
  Field out(flux.size());
  ComplexField work;
  convolution_.apply(displacement_, flux.data(), out.data(), work);
  return out;
}

Field FluxHeat::stress(const Field& flux, std::span<const double> depths) const {
  const std::size_t plane = flux.size(), count = depths.size();
  Field out(6 * count * plane, 0.0);
  ComplexField work;
  for (std::size_t d = 0; d < count; ++d) {
    HeatStress::Tables tables = stress_.at(depths[d], grid_, convolution_.offsets());
    for (std::size_t c = 0; c < 6; ++c) {
      const auto here = kernels_of(std::move(tables[c]),
                                   kernels::component_parity(static_cast<int>(c)), convolution_);
      if (here.empty()) continue;
      convolution_.apply(here, flux.data(), out.data() + (c * count + d) * plane, work);
    }
  }
  return out;
}

}  // namespace samcontact::operators
