// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual_displacement.hpp"

#include <algorithm>
#include <numbers>

#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/layer_differences.hpp"
#include "samcontact/operators/parity_product.hpp"

namespace samcontact::operators {

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const fft::PaddedTransform& transform,
                                           double nu, Tensor tensor)
    : transform_(&transform), nz_(grid.nz), tensor_(tensor) {
  const fft::ParitySpectrum spectrum(transform);
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const double dz = grid.dz / grid.dx;
  // Lengths are in units of dx, so the displacement is too.
  const double factor = grid.dx / (2 * std::numbers::pi);
  const auto places = components(tensor);
  const int count = static_cast<int>(places.size());
  // A deviator's zz is -(xx + yy).
  const auto corner = [nu, tensor](double x, double y, double z) -> std::array<double, 6> {
    const auto d = kernels::eigenstrain_displacement(x, y, z, nu);
    if (tensor == Tensor::full) return d;
    return {d[0] - d[2], d[1] - d[2], d[3], d[4], d[5], 0.0};
  };
  spectra_.resize(spectrum.size() * count * nz_);
  for_each_layer_difference<6>(
      lattice, nz_, [dz](int level) { return level * dz; },
      corner, [&](int k, const double* differences) {
        Field quarter(spectrum.size());
        for (int c = 0; c < count; ++c) {
          lattice.corner_sums(differences + c * lattice.size(), quarter.data(), hx, hy);
          const auto parity = kernels::component_parity(places[c]);
          spectrum.transform(quarter.data(), parity.odd_x, parity.odd_y);
          for (int ky = 0; ky < hy; ++ky) {
            double* to = spectra_.data() + ((static_cast<std::size_t>(ky) * count + c) * nz_ + k) * hx;
            const double* from = quarter.data() + static_cast<std::size_t>(ky) * hx;
            std::transform(from, from + hx, to, [factor](double v) { return factor * v; });
          }
        }
      });
}

void ResidualDisplacement::apply(const VolumeSpectrum& strain, double* displacement) const {
  const int mx = strain.mx, hx = mx / 2 + 1;
  const auto places = components(tensor_);
  ComplexField sum(transform_->spectrum_size());
#pragma omp parallel for schedule(static)
  for (int ky = 0; ky < strain.mh; ++ky) {
    Complex* out = sum.data() + static_cast<std::size_t>(ky) * mx;
    const double* quarter = spectra_.data() + static_cast<std::size_t>(ky) * strain.components * nz_ * hx;
    for (int c = 0; c < strain.components; ++c) {
      for (int k = 0; k < nz_; ++k, quarter += hx) {
        if (!strain.used[k]) continue;
        add_parity_product(quarter, kernels::component_parity(places[c]), 1.0, strain.column(ky, c, k), out,
                           mx);
      }
    }
  }
  transform_->inverse(sum.data(), displacement, mx, fft::PaddedTransform::Threads::many);
}

}  // namespace samcontact::operators
