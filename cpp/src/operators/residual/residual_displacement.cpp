// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/residual_displacement.hpp"

#include <algorithm>
#include <numbers>

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
    : transform_(&transform),
      axis_(axis),
      nz_(layers),
      first_(shallower != nullptr ? std::min(layers, shallower->nz_) : 0),
      tensor_(tensor) {
  const fft::ParitySpectrum spectrum(transform.mx(), transform.my());
  spectra_.resize(spectrum.size() * count(tensor) * nz_);
  if (shallower != nullptr) {
    copy_layers(shallower->spectra_, shallower->nz_, spectra_, nz_, spectrum.hx());
  }
}

void ResidualDisplacement::store(const fft::ParitySpectrum& spectrum, int component, int layer,
                                 double* quarter) {
  const auto places = components(tensor_);
  const auto parity = stress_parity(traction_along(axis_), places[component]);
  const int hx = spectrum.hx(), hy = spectrum.hy();
  spectrum.transform(quarter, parity.odd_x, parity.odd_y);
  for (int ky = 0; ky < hy; ++ky) {
    const std::size_t row = static_cast<std::size_t>(ky) * places.size() + component;
    std::copy_n(quarter + static_cast<std::size_t>(ky) * hx, hx,
                spectra_.data() + (row * nz_ + layer) * hx);
  }
}

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const VolumeTransform& transform,
                                           double nu, Axis axis, Tensor tensor,
                                           const ResidualDisplacement* shallower)
    : ResidualDisplacement(transform, axis, grid.nz, tensor, shallower) {
  const fft::ParitySpectrum spectrum(transform.mx(), transform.my());
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  const double dz = grid.dz / grid.dx;
  // Lengths are in units of dx, and so is the displacement.
  const double factor = grid.dx / (2 * std::numbers::pi);
  // zz of a deviator is -(xx + yy).
  const auto corner = [nu, axis, tensor](double x, double y, double z) -> std::array<double, 6> {
    const auto d = residual_corner(axis, x, y, z, nu);
    if (tensor == Tensor::full) return d;
    return {d[0] - d[2], d[1] - d[2], d[3], d[4], d[5], 0.0};
  };
  for_each_layer_difference<6>(
      lattice, nz_ - first_, [&](int level) { return (grid.k0 + first_ + level) * dz; }, corner,
      [&](int k, const double* differences) {
        Field quarter(spectrum.size());
        for (int c = 0; c < count(tensor); ++c) {
          lattice.corner_sums(differences + c * lattice.size(), quarter.data(), spectrum.hx(),
                              spectrum.hy());
          for (double& value : quarter) value *= factor;
          store(spectrum, c, first_ + k, quarter.data());
        }
      },
      axis == Axis::z ? &exchanged_places(tensor) : nullptr);
}

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const VolumeTransform& transform,
                                           Axis axis, const std::function<Field(int layer)>& tables,
                                           int layers, Tensor tensor,
                                           const ResidualDisplacement* shallower)
    : ResidualDisplacement(transform, axis, layers, tensor, shallower) {
  const fft::ParitySpectrum spectrum(transform.mx(), transform.my());
  const KernelOffsets offsets(grid, transform.mx(), transform.my());
  const std::size_t plane = static_cast<std::size_t>(offsets.nx) * offsets.ny;
  const auto places = components(tensor);
#pragma omp parallel for schedule(dynamic)
  for (int k = first_; k < nz_; ++k) {
    const Field table = tables(k);
    for (std::size_t c = 0; c < places.size(); ++c) {
      const double* from = table.data() + places[c] * plane;
      // zz of a deviator is -(xx + yy).
      const double* less =
          tensor == Tensor::deviator && places[c] < 2 ? &table[2 * plane] : nullptr;
      Field quarter(spectrum.size(), 0.0);
      for (std::size_t n = 0; n < plane; ++n) {
        quarter[n / offsets.nx * spectrum.hx() + n % offsets.nx] =
            from[n] - (less != nullptr ? less[n] : 0.0);
      }
      store(spectrum, static_cast<int>(c), k, quarter.data());
    }
  }
}

void ResidualDisplacement::apply(const VolumeSpectrum& strain, double* displacement) const {
  const int hx = strain.mx / 2 + 1;
  const auto places = components(tensor_);
  Field sum(strain.mh * strain.row_size());
#pragma omp parallel for schedule(static) if (2.0 * strain.data.size() > min_parallel_operations)
  for (int ky = 0; ky < strain.mh; ++ky) {
    double* out = sum.data() + ky * strain.row_size();
    for (int c = 0; c < strain.components; ++c) {
      const double* quarter =
          spectra_.data() + (static_cast<std::size_t>(ky) * strain.components + c) * nz_ * hx;
      const auto parity = stress_parity(traction_along(axis_), places[c]);
      const double sign =
          mirror_sign(strain.symmetry, parity, kernels::component_parity(places[c]));
      for (int k = 0; k < std::min(nz_, strain.nz); ++k, quarter += hx) {
        if (!strain.used[k]) continue;
        add_parity_product(quarter, parity, sign, strain.row(ky, c, k), out, *transform_);
      }
    }
  }
  transform_->inverse(sum, displacement, vector_parity(traction_along(axis_)));
}

}  // namespace samcontact::operators
