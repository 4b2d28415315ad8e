// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "samcontact/base/interrupt.hpp"
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
      traction_stress_(grid, transform_, elastic, options.heat, grid.z(), options.tensor) {}

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
  const auto add = [&](std::span<const Traction> kinds, const Field& field, double scale) {
    if (field.empty()) return;
    const Field spectrum = transform_.forward(field.data());
    for (const Traction kind : kinds) {
      {
        const std::lock_guard lock(mutex_);
        traction_stress_.prepare(kind);
      }
      traction_stress_.add(kind, spectrum, scale, out);
    }
  };
  add(traction_stress_.pressure_kinds(), tractions.pressure, 1.0);
  add(std::array{Traction::shear_x}, tractions.shear_x, shear_sign);
  add(std::array{Traction::shear_y}, tractions.shear_y, shear_sign);
}

void VolumeOperators::for_each_layer(
    VolumeSpectrum& spectrum, const double* strain, const Tractions* tractions, double shear_sign,
    const std::function<void(int layer, const double* stress)>& use) const {
  check_interrupt();
  Field far_field;
  if (strain != nullptr) {
    residual_stress().apply(spectrum);
    far_field = residual_stress().far_field(options_.tensor, strain);
  }
  if (tractions != nullptr) add_tractions(*tractions, shear_sign, spectrum);
  const std::size_t layer_size = count(options_.tensor) * transform_.plane_size();
#pragma omp parallel
  {
    Field layer(layer_size);
#pragma omp for schedule(dynamic)
    for (int k = 0; k < grid_.nz; ++k) {
      inverse(transform_, spectrum, k, layer.data());
      if (strain != nullptr) residual_stress_->correct(options_.tensor, far_field, k, layer.data());
      use(k, layer.data());
    }
  }
}

Field VolumeOperators::stress(const double* strain, const Tractions* tractions,
                              double shear_sign) const {
  VolumeSpectrum spectrum = make_spectrum();
  if (strain != nullptr) forward(transform_, strain, spectrum);
  const std::size_t plane = transform_.plane_size(), volume = plane * grid_.nz;
  const int parts = count(options_.tensor);
  Field out(parts * volume);
  for_each_layer(spectrum, strain, tractions, shear_sign, [&](int k, const double* layer) {
    for (int c = 0; c < parts; ++c) {
      std::copy_n(layer + c * plane, plane, out.data() + c * volume + k * plane);
    }
  });
  return out;
}

std::size_t VolumeOperators::bytes() const {
  const std::lock_guard lock(mutex_);
  return traction_stress_.bytes() + (residual_stress_ ? residual_stress_->bytes() : 0) +
         (residual_displacement_ ? residual_displacement_->bytes() : 0);
}

}  // namespace samcontact::operators
