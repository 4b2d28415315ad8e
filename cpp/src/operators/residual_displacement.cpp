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
                                           double nu)
    : transform_(&transform), nz_(grid.nz) {
  const fft::ParitySpectrum spectrum(transform);
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const double dz = grid.dz / grid.dx;
  // Lengths are in units of dx, so the displacement is too.
  const double factor = grid.dx / (2 * std::numbers::pi);
  spectra_.resize(spectrum.size() * 6 * nz_);
  for_each_layer_difference<6>(
      lattice, nz_, [dz](int level) { return level * dz; },
      [nu](double x, double y, double z) { return kernels::eigenstrain_displacement(x, y, z, nu); },
      [&](int k, const double* differences) {
        Field quarter(spectrum.size());
        for (int c = 0; c < 6; ++c) {
          lattice.corner_sums(differences + c * lattice.size(), quarter.data(), hx, hy);
          const auto parity = kernels::component_parity(c);
          spectrum.transform(quarter.data(), parity.odd_x, parity.odd_y);
          for (int ky = 0; ky < hy; ++ky) {
            double* to = spectra_.data() + ((static_cast<std::size_t>(ky) * 6 + c) * nz_ + k) * hx;
            const double* from = quarter.data() + static_cast<std::size_t>(ky) * hx;
            std::transform(from, from + hx, to, [factor](double v) { return factor * v; });
          }
        }
      });
}

void ResidualDisplacement::apply(const VolumeSpectrum& strain, double* displacement) const {
  const int mx = strain.mx, hx = mx / 2 + 1;
  ComplexField sum(transform_->spectrum_size());
#pragma omp parallel for schedule(static)
  for (int ky = 0; ky < strain.mh; ++ky) {
    Complex* out = sum.data() + static_cast<std::size_t>(ky) * mx;
    const double* quarter = spectra_.data() + static_cast<std::size_t>(ky) * 6 * nz_ * hx;
    for (int c = 0; c < 6; ++c) {
      for (int k = 0; k < nz_; ++k, quarter += hx) {
        if (!strain.used[k]) continue;
        add_parity_product(quarter, kernels::component_parity(c), 1.0, strain.column(ky, c, k), out,
                           mx);
      }
    }
  }
  transform_->inverse(sum.data(), displacement, mx, fft::PaddedTransform::Threads::many);
}

}  // namespace samcontact::operators
