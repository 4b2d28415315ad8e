// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume/volume_operators.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::operators {
namespace {

/// The images of a long narrow box would come too close to its ends: the shorter period is at least
/// this fraction of the longer one.
constexpr double shortest_period = 0.25;
/// On a surface that is periodic in one direction, fields that vary along it decay as exp(-2 pi x)
/// with the distance x in periods.
constexpr double clear_periods = 2.0;

VolumeTransform make_transform(const Grid& grid, const VolumeOptions& options) {
  int mx = 0, my = 0;
  if (grid.period.is_on()) {
    mx = grid.nx + static_cast<int>(std::ceil(clear_periods * grid.period.y * grid.dy / grid.dx));
    my = grid.ny + static_cast<int>(std::ceil(clear_periods * grid.period.x * grid.dx / grid.dy));
  } else if (options.method == ResidualMethod::fast) {
    mx = static_cast<int>(std::ceil(shortest_period * (2 * grid.ny - 1) * grid.dy / grid.dx));
    my = static_cast<int>(std::ceil(shortest_period * (2 * grid.nx - 1) * grid.dx / grid.dy));
  }
  return {grid, options.symmetry, mx, my};
}

/// Grid of the offsets that occur.
Grid within(const Reach& reach, Grid grid) {
  grid.nx = std::min(grid.nx, reach.x);
  grid.ny = std::min(grid.ny, reach.y);
  return grid;
}

/// Mid-depths of the layers.
std::vector<double> stressed_depths(const Grid& grid, const Medium& medium) {
  std::vector<double> depths = grid.z();
  depths.resize(medium.stressed_layers(grid));
  return depths;
}

}  // namespace

VolumeOperators::VolumeOperators(const Grid& grid, SharedMedium medium,
                                 const VolumeOptions& options,
                                 std::shared_ptr<const VolumeOperators> shallower)
    : grid_(grid),
      medium_(std::move(medium)),
      options_(options),
      transform_(make_transform(grid, options)),
      shallower_(std::move(shallower)),
      traction_stress_(within(options.reach, grid), transform_, medium_, options.heat,
                       stressed_depths(grid, *medium_), options.tensor) {
  if (!shallower_) return;
  // One of them suffices.
  const std::lock_guard lock(shallower_->mutex_);
  shallower_->shallower_.reset();
}

const ResidualStress& VolumeOperators::residual_stress() const {
  const std::lock_guard lock(mutex_);
  if (!residual_stress_) {
    residual_stress_ =
        medium_->residual_stress(grid_, transform_, {options_.method, options_.image_tol});
  }
  return *residual_stress_;
}

const ResidualDisplacement& VolumeOperators::residual_displacement(Axis axis) const {
  const std::lock_guard lock(mutex_);
  auto& displacement = residual_displacement_[static_cast<int>(axis)];
  if (!displacement) {
    std::unique_lock<std::mutex> other;
    if (shallower_) other = std::unique_lock(shallower_->mutex_);
    const auto* known =
        shallower_ ? shallower_->residual_displacement_[static_cast<int>(axis)].get() : nullptr;
    displacement = medium_->residual_displacement(axis, within(options_.reach, grid_), transform_,
                                                  options_.tensor, known);
    other = {};
    release_shallower();
  }
  return *displacement;
}

void VolumeOperators::release_shallower() const {
  if (residual_displacement_[static_cast<int>(Axis::z)] && traction_stress_.bytes() > 0)
    shallower_.reset();
}

void VolumeOperators::for_each_layer(
    VolumeSpectrum& spectrum, const double* strain, const Tractions* tractions, double shear_sign,
    const std::function<void(int layer, const double* stress)>& use, int layers, const Rows& rows,
    int first) const {
  check_interrupt();
  Field far_field;
  if (strain != nullptr) {
    residual_stress().apply(spectrum);
    far_field = residual_stress().far_field(options_.tensor, strain);
  }
  if (tractions != nullptr) {
    std::shared_ptr<const VolumeOperators> other;
    {
      const std::lock_guard lock(mutex_);
      other = shallower_;
    }
    traction_stress_.add(*tractions, shear_sign, spectrum,
                         other ? &other->traction_stress_ : nullptr, first);
    const std::lock_guard lock(mutex_);
    release_shallower();
  }
  const std::size_t layer_size = count(options_.tensor) * transform_.plane_size();
#pragma omp parallel if (per_number * layer_size * grid_.nz > min_parallel_operations)
  {
    Field layer(layer_size);
#pragma omp for schedule(dynamic)
    for (int k = first; k < std::min(layers, spectrum.nz); ++k) {
      inverse(transform_, spectrum, k, layer.data(),
              rows ? rows(k) : std::span<const fft::RowRun>());
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
  std::size_t bytes = traction_stress_.bytes();
  if (residual_stress_) bytes += residual_stress_->bytes();
  for (const auto& displacement : residual_displacement_) {
    if (displacement) bytes += displacement->bytes();
  }
  return bytes;
}

}  // namespace samcontact::operators
