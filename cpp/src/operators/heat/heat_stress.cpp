// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_stress.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::operators {
namespace {

/// Maximum size of the tables of all layers; larger ones are computed again for each box.
constexpr double max_kept = 64e6;
/// Assumed number of layers if it is not limited.
constexpr int usual_layers = 64;

ParityParts cropped(const ParityParts& from, int from_nx, const KernelOffsets& offsets) {
  const auto [nx, ny] = offsets;
  ParityParts to;
  for (int part = 0; part < 4; ++part) {
    if (from[part].empty()) continue;
    to[part].resize(static_cast<std::size_t>(nx) * ny);
    for (int j = 0; j < ny; ++j) {
      std::copy_n(from[part].data() + static_cast<std::size_t>(j) * from_nx, nx,
                  to[part].data() + static_cast<std::size_t>(j) * nx);
    }
  }
  return to;
}

}  // namespace

std::vector<ParityParts> parts_of(std::array<ParityParts, 6> stress, Tensor tensor) {
  if (tensor == Tensor::deviator) {
    for (int part = 0; part < 4; ++part) {
      Field &xx = stress[0][part], &yy = stress[1][part];
      const Field& zz = stress[2][part];
      for (std::size_t n = 0; n < xx.size(); ++n) {
        const double mean = (xx[n] + yy[n] + (zz.empty() ? 0.0 : zz[n])) / 3;
        xx[n] -= mean;
        yy[n] -= mean;
      }
    }
  }
  std::vector<ParityParts> parts;
  for (const int c : components(tensor)) parts.push_back(std::move(stress[c]));
  return parts;
}

HeatStress::HeatStress(SharedThermalStress body, Heating heating)
    : body_(std::move(body)), heating_(std::move(heating)) {}

HeatStress::HeatStress(const Grid& widest, SharedThermalStress body, const Heating& heating)
    : HeatStress(std::move(body), heating) {
  const double parts = (heating.speed_x != 0 ? 2 : 1) * (heating.speed_y != 0 ? 2 : 1);
  const int layers = widest.nz > 0 ? widest.nz : usual_layers;
  const double numbers = 6 * parts * widest.surface_size() * layers;
  if (!body_->is_fast(heating) && numbers <= max_kept) widest_ = widest;
}

HeatStress::Tables HeatStress::compute(double z, const Grid& grid,
                                       const KernelOffsets& offsets) const {
  return body_->stress(heating_, grid.dx, grid.dy, z,
                       Offsets::lattice(grid.dx, grid.dy, offsets.nx, offsets.ny));
}

HeatStress::Tables HeatStress::at(double z, const Grid& grid, const KernelOffsets& offsets) const {
  const bool fits = widest_ && grid.dx == widest_->dx && grid.dy == widest_->dy &&
                    offsets.nx <= widest_->nx && offsets.ny <= widest_->ny;
  if (!fits) return compute(z, grid, offsets);
  std::shared_ptr<const Tables> tables;
  {
    const std::lock_guard lock(mutex_);
    auto& kept = kept_[z];
    if (!kept) {
      const KernelOffsets all(widest_->nx, widest_->ny);
      kept = std::make_shared<const Tables>(compute(z, *widest_, all));
    }
    tables = kept;
  }
  Tables parts;
  for (int c = 0; c < 6; ++c) parts[c] = cropped((*tables)[c], widest_->nx, offsets);
  return parts;
}

std::size_t HeatStress::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t numbers = 0;
  for (const auto& [z, tables] : kept_) {
    for (const auto& component : *tables) {
      for (const Field& part : component) numbers += part.size();
    }
  }
  return numbers * sizeof(double);
}

}  // namespace samcontact::operators
