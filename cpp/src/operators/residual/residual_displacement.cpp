// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/residual_displacement.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/convolution/parity_product.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/influence/influence_lattice.hpp"
#include "samcontact/operators/influence/layer_differences.hpp"
#include "samcontact/operators/periodic/cell_influence.hpp"

namespace samcontact::operators {

ResidualDisplacement::ResidualDisplacement(const VolumeTransform& transform, Axis axis, int layers,
                                           Tensor tensor, const ResidualDisplacement* shallower)
    : transform_(&transform), axis_(axis), tensor_(tensor), kernels_(layers) {
  if (shallower == nullptr) return;
  const std::lock_guard lock(shallower->mutex_);
  std::copy_n(shallower->kernels_.begin(), std::min(layers, shallower->layers()), kernels_.begin());
}

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const VolumeTransform& transform,
                                           double nu, Axis axis, Tensor tensor,
                                           const ResidualDisplacement* shallower)
    : ResidualDisplacement(transform, axis, grid.nz, tensor, shallower) {
  build_ = [this, grid, nu](int first, int last) { build(grid, nu, first, last); };
}

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const VolumeTransform& transform,
                                           Axis axis, std::function<Field(int layer)> tables,
                                           int layers, Tensor tensor,
                                           const ResidualDisplacement* shallower)
    : ResidualDisplacement(transform, axis, layers, tensor, shallower) {
  const KernelOffsets offsets(grid, transform.mx(), transform.my());
  build_ = [this, offsets, tables = std::move(tables)](int first, int last) {
    build(offsets, tables, first, last);
  };
}

void ResidualDisplacement::store(const fft::ParitySpectrum& spectrum, int component,
                                 double* quarter, Field& kernel) const {
  const auto places = components(tensor_);
  const auto parity = stress_parity(traction_along(axis_), places[component]);
  const int hx = spectrum.hx(), hy = spectrum.hy();
  spectrum.transform(quarter, parity.odd_x, parity.odd_y);
  for (int ky = 0; ky < hy; ++ky) {
    const std::size_t row = static_cast<std::size_t>(ky) * places.size() + component;
    std::copy_n(quarter + static_cast<std::size_t>(ky) * hx, hx, kernel.data() + row * hx);
  }
}

void ResidualDisplacement::build(const Grid& grid, double nu, int first, int last) const {
  const fft::ParitySpectrum spectrum(transform_->mx(), transform_->my());
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  const double dz = grid.dz / grid.dx;
  // Lengths are in units of dx, and so is the displacement.
  const double factor = grid.dx / (2 * std::numbers::pi);
  // zz of a deviator is -(xx + yy).
  const auto corner = [nu, axis = axis_, tensor = tensor_](double x, double y,
                                                           double z) -> std::array<double, 6> {
    const auto d = residual_corner(axis, x, y, z, nu);
    if (tensor == Tensor::full) return d;
    return {d[0] - d[2], d[1] - d[2], d[3], d[4], d[5], 0.0};
  };
  for_each_layer_difference<6>(
      lattice, last - first, [&](int level) { return (grid.k0 + first + level) * dz; }, corner,
      [&](int k, const double* differences) {
        Field quarter(spectrum.size()), kernel(spectrum.size() * count(tensor_));
        for (int c = 0; c < count(tensor_); ++c) {
          lattice.corner_sums(differences + c * lattice.size(), quarter.data(), spectrum.hx(),
                              spectrum.hy());
          for (double& value : quarter) value *= factor;
          store(spectrum, c, quarter.data(), kernel);
        }
        kernels_[first + k] = std::make_shared<const Field>(std::move(kernel));
      },
      axis_ == Axis::z ? &exchanged_places(tensor_) : nullptr);
}

void ResidualDisplacement::build(const KernelOffsets& offsets,
                                 const std::function<Field(int layer)>& tables, int first,
                                 int last) const {
  const fft::ParitySpectrum spectrum(transform_->mx(), transform_->my());
  const std::size_t plane = static_cast<std::size_t>(offsets.nx) * offsets.ny;
  const auto places = components(tensor_);
#pragma omp parallel for schedule(dynamic)
  for (int k = first; k < last; ++k) {
    const Field table = tables(k);
    Field kernel(spectrum.size() * places.size());
    for (std::size_t c = 0; c < places.size(); ++c) {
      const double* from = table.data() + places[c] * plane;
      // zz of a deviator is -(xx + yy).
      const double* less =
          tensor_ == Tensor::deviator && places[c] < 2 ? &table[2 * plane] : nullptr;
      Field quarter(spectrum.size(), 0.0);
      for (std::size_t n = 0; n < plane; ++n) {
        quarter[n / offsets.nx * spectrum.hx() + n % offsets.nx] =
            from[n] - (less != nullptr ? less[n] : 0.0);
      }
      store(spectrum, static_cast<int>(c), quarter.data(), kernel);
    }
    kernels_[k] = std::make_shared<const Field>(std::move(kernel));
  }
}

void ResidualDisplacement::prepare(const std::vector<char>& used) const {
  const std::lock_guard lock(mutex_);
  const int end = std::min(layers(), static_cast<int>(used.size()));
  const auto missing = [&](int k) { return k < end && used[k] != 0 && !kernels_[k]; };
  for (int first = 0; first < end; ++first) {
    if (!missing(first)) continue;
    int last = first + 1;
    while (missing(last)) ++last;
    build_(first, last);
    first = last;
  }
}

void ResidualDisplacement::build_all() const { prepare(std::vector<char>(layers(), 1)); }

void ResidualDisplacement::apply(const VolumeSpectrum& strain, double* displacement) const {
  prepare(strain.used);
  const int hx = strain.mx / 2 + 1;
  const auto places = components(tensor_);
  Field sum(strain.mh * strain.row_size());
#pragma omp parallel for schedule(static) if (2.0 * strain.data.size() > min_parallel_operations)
  for (int ky = 0; ky < strain.mh; ++ky) {
    double* out = sum.data() + ky * strain.row_size();
    for (int c = 0; c < strain.components; ++c) {
      const std::size_t row = (static_cast<std::size_t>(ky) * strain.components + c) * hx;
      const auto parity = stress_parity(traction_along(axis_), places[c]);
      const double sign =
          mirror_sign(strain.symmetry, parity, kernels::component_parity(places[c]));
      for (int k = 0; k < std::min(layers(), strain.nz); ++k) {
        if (!strain.used[k]) continue;
        add_parity_product(kernels_[k]->data() + row, parity, sign, strain.row(ky, c, k), out,
                           *transform_);
      }
    }
  }
  transform_->inverse(sum, displacement, vector_parity(traction_along(axis_)));
}

std::size_t ResidualDisplacement::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t values = 0;
  for (const auto& kernel : kernels_) values += kernel ? kernel->size() : 0;
  return values * sizeof(double);
}

}  // namespace samcontact::operators
