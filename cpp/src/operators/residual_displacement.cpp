// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual_displacement.hpp"

#include <algorithm>
#include <numbers>

#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/layer_differences.hpp"
#include "samcontact/operators/parity_product.hpp"

namespace samcontact::operators {

ResidualDisplacement::ResidualDisplacement(const Grid& grid, const VolumeTransform& transform,
                                           double nu, Tensor tensor)
    : transform_(&transform), nz_(grid.nz), tensor_(tensor) {
  const fft::ParitySpectrum spectrum(transform.mx(), transform.my());
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
      lattice, nz_, [dz](int level) { return level * dz; }, corner,
      [&](int k, const double* differences) {
        Field quarter(spectrum.size());
        for (int c = 0; c < count; ++c) {
          lattice.corner_sums(differences + c * lattice.size(), quarter.data(), hx, hy);
          const auto parity = kernels::component_parity(places[c]);
          spectrum.transform(quarter.data(), parity.odd_x, parity.odd_y);
          for (int ky = 0; ky < hy; ++ky) {
            double* to =
                spectra_.data() + ((static_cast<std::size_t>(ky) * count + c) * nz_ + k) * hx;
            const double* from = quarter.data() + static_cast<std::size_t>(ky) * hx;
            std::transform(from, from + hx, to, [factor](double v) { return factor * v; });
          }
        }
      });
}

void ResidualDisplacement::apply(const VolumeSpectrum& strain, double* displacement) const {
  const int hx = strain.mx / 2 + 1;
  const auto places = components(tensor_);
  Field sum(strain.mh * strain.row_size());
#pragma omp parallel for schedule(static) if (2.0 * strain.data.size() > worth_threads)
  for (int ky = 0; ky < strain.mh; ++ky) {
    double* out = sum.data() + ky * strain.row_size();
    const double* quarter =
        spectra_.data() + static_cast<std::size_t>(ky) * strain.components * nz_ * hx;
    for (int c = 0; c < strain.components; ++c) {
      const auto parity = kernels::component_parity(places[c]);
      // The strain's own factor (-i) meets that of the kernel.
      const bool negative = (strain.symmetry != Symmetry::none && parity.odd_y) !=
                            (strain.symmetry == Symmetry::xy && parity.odd_x);
      for (int k = 0; k < nz_; ++k, quarter += hx) {
        if (!strain.used[k]) continue;
        add_parity_product(quarter, parity, negative ? -1.0 : 1.0, strain.row(ky, c, k), out,
                           *transform_);
      }
    }
  }
  transform_->inverse(sum, displacement);
}

}  // namespace samcontact::operators
