// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_operators.hpp"

namespace samcontact::operators {

VolumeOperators::VolumeOperators(const Grid& grid, const Elastic& elastic)
    : grid_(grid),
      elastic_(elastic),
      transform_(grid.nx, grid.ny),
      traction_stress_(grid, transform_, elastic.nu, grid.z()) {}

const ResidualStress& VolumeOperators::residual_stress() const {
  const std::lock_guard lock(mutex_);
  if (!residual_stress_) {
    residual_stress_ = std::make_unique<ResidualStress>(grid_, transform_, elastic_);
  }
  return *residual_stress_;
}

const ResidualDisplacement& VolumeOperators::residual_displacement() const {
  const std::lock_guard lock(mutex_);
  if (!residual_displacement_) {
    residual_displacement_ = std::make_unique<ResidualDisplacement>(grid_, transform_, elastic_.nu);
  }
  return *residual_displacement_;
}

void VolumeOperators::add_tractions(const Tractions& tractions, double shear_sign,
                                    VolumeSpectrum& out) const {
  ComplexField spectrum(transform_.spectrum_size());
  const auto add = [&](Traction kind, const Field& field, double scale) {
    if (field.empty()) return;
    {
      const std::lock_guard lock(mutex_);
      traction_stress_.prepare(kind);
    }
    transform_.forward(field.data(), spectrum.data(), transform_.mx(),
                       fft::PaddedTransform::Threads::many);
    traction_stress_.add(kind, spectrum, scale, out);
  };
  add(Traction::pressure, tractions.pressure, 1.0);
  add(Traction::shear_x, tractions.shear_x, shear_sign);
  add(Traction::shear_y, tractions.shear_y, shear_sign);
}

std::size_t VolumeOperators::bytes() const {
  const std::lock_guard lock(mutex_);
  return traction_stress_.bytes() + (residual_stress_ ? residual_stress_->bytes() : 0) +
         (residual_displacement_ ? residual_displacement_->bytes() : 0);
}

}  // namespace samcontact::operators
