// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_operators.hpp"

#include <cmath>

#include "samcontact/operators/cuboid_residual_stress.hpp"
#include "samcontact/operators/layer_residual_stress.hpp"

namespace samcontact::operators {
namespace {

/// The images of a long narrow box would come too near to its ends: the short period is at least
/// this part of the long one.
constexpr double shortest_period = 0.25;

VolumeTransform make_transform(const Grid& grid, const VolumeOptions& options) {
  int mx = 0, my = 0;
  if (options.method == ResidualMethod::fast) {
    mx = static_cast<int>(std::ceil(shortest_period * (2 * grid.ny - 1) * grid.dy / grid.dx));
    my = static_cast<int>(std::ceil(shortest_period * (2 * grid.nx - 1) * grid.dx / grid.dy));
  }
  return {grid.nx, grid.ny, options.symmetry, mx, my};
}

}  // namespace

VolumeOperators::VolumeOperators(const Grid& grid, const Elastic& elastic,
                                 const VolumeOptions& options)
    : grid_(grid),
      elastic_(elastic),
      options_(options),
      transform_(make_transform(grid, options)),
      traction_stress_(grid, transform_, elastic.nu, grid.z(), options.tensor) {}

const ResidualStress& VolumeOperators::residual_stress() const {
  const std::lock_guard lock(mutex_);
  if (!residual_stress_) {
    if (options_.method == ResidualMethod::exact) {
      residual_stress_ = std::make_unique<CuboidResidualStress>(grid_, transform_, elastic_);
    } else {
      residual_stress_ =
          std::make_unique<LayerResidualStress>(grid_, transform_, elastic_, options_.image_tol);
    }
  }
  return *residual_stress_;
}

const ResidualDisplacement& VolumeOperators::residual_displacement() const {
  const std::lock_guard lock(mutex_);
  if (!residual_displacement_) {
    residual_displacement_ =
        std::make_unique<ResidualDisplacement>(grid_, transform_, elastic_.nu, options_.tensor);
  }
  return *residual_displacement_;
}

void VolumeOperators::add_tractions(const Tractions& tractions, double shear_sign,
                                    VolumeSpectrum& out) const {
  const auto add = [&](Traction kind, const Field& field, double scale) {
    if (field.empty()) return;
    {
      const std::lock_guard lock(mutex_);
      traction_stress_.prepare(kind);
    }
    traction_stress_.add(kind, transform_.forward(field.data()), scale, out);
  };
  add(Traction::pressure, tractions.pressure, 1.0);
  add(Traction::shear_x, tractions.shear_x, shear_sign);
  add(Traction::shear_y, tractions.shear_y, shear_sign);
}

Field VolumeOperators::stress(const double* strain, const Tractions* tractions,
                              double shear_sign) const {
  VolumeSpectrum spectrum = make_spectrum();
  if (strain != nullptr) {
    forward(transform_, strain, spectrum);
    residual_stress().apply(spectrum);
  }
  if (tractions != nullptr) add_tractions(*tractions, shear_sign, spectrum);
  Field out(count(options_.tensor) * transform_.plane_size() * grid_.nz);
  inverse(transform_, spectrum, out.data());
  if (strain != nullptr) residual_stress().correct(options_.tensor, strain, out.data());
  return out;
}

std::size_t VolumeOperators::bytes() const {
  const std::lock_guard lock(mutex_);
  return traction_stress_.bytes() + (residual_stress_ ? residual_stress_->bytes() : 0) +
         (residual_displacement_ ? residual_displacement_->bytes() : 0);
}

}  // namespace samcontact::operators
