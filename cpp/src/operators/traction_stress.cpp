// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/traction_stress.hpp"

#include <numbers>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/parity_product.hpp"

namespace samcontact::operators {
namespace {

kernels::Parity parity(Traction kind, int component) {
  auto p = kernels::component_parity(component);
  if (kind == Traction::shear_x) p.odd_x = !p.odd_x;
  if (kind == Traction::shear_y) p.odd_y = !p.odd_y;
  return p;
}

kernels::Stress corner_stress(Traction kind, double x, double y, double z, double nu) {
  if (kind == Traction::pressure) return kernels::pressure_stress(x, y, z, nu);
  if (kind == Traction::shear_x) return kernels::shear_stress(x, y, z, nu);
  const auto s = kernels::shear_stress(y, x, z, nu);
  return {s[1], s[0], s[2], s[4], s[3], s[5]};
}

/// The components of the field that are asked for come first.
kernels::Stress select(kernels::Stress s, Tensor tensor) {
  if (tensor == Tensor::full) return s;
  const double mean = (s[0] + s[1] + s[2]) / 3;
  return {s[0] - mean, s[1] - mean, s[3], s[4], s[5], 0.0};
}

}  // namespace

TractionStress::TractionStress(const Grid& grid, const VolumeTransform& transform, double nu,
                               std::vector<double> depths, Tensor tensor)
    : grid_(grid), transform_(&transform), nu_(nu), depths_(std::move(depths)), tensor_(tensor) {}

void TractionStress::prepare(Traction kind) {
  Field& spectra = spectra_[static_cast<int>(kind)];
  if (!spectra.empty()) return;
  const fft::ParitySpectrum parity_spectrum(transform_->mx(), transform_->my());
  const CornerLattice lattice{grid_.nx, grid_.ny, grid_.dy / grid_.dx};
  const int nz = layers(), hx = parity_spectrum.hx(), hy = parity_spectrum.hy();
  const auto places = components(tensor_);
  const int count = static_cast<int>(places.size());
  Field built(parity_spectrum.size() * count * nz);
  check_interrupt();
#pragma omp parallel
  {
    Field corners(6 * lattice.size()), quarter(parity_spectrum.size());
#pragma omp for schedule(dynamic)
    for (int k = 0; k < nz; ++k) {
      const double z = depths_[k] / grid_.dx;
      lattice.evaluate<6>(
          [&](double x, double y) { return select(corner_stress(kind, x, y, z, nu_), tensor_); },
          corners.data());
      for (int c = 0; c < count; ++c) {
        lattice.corner_sums(corners.data() + c * lattice.size(), quarter.data(), hx, hy);
        const auto p = parity(kind, places[c]);
        parity_spectrum.transform(quarter.data(), p.odd_x, p.odd_y);
        for (int ky = 0; ky < hy; ++ky) {
          for (int kx = 0; kx < hx; ++kx) {
            built[((static_cast<std::size_t>(ky) * count + c) * nz + k) * hx + kx] =
                quarter[static_cast<std::size_t>(ky) * hx + kx] / (2 * std::numbers::pi);
          }
        }
      }
    }
  }
  spectra = std::move(built);
}

void TractionStress::add(Traction kind, const Field& traction, double scale,
                         VolumeSpectrum& out) const {
  const Field& spectra = spectra_[static_cast<int>(kind)];
  const int nz = layers(), hx = out.mx / 2 + 1;
  const auto places = components(tensor_);
#pragma omp parallel for schedule(static) if (2.0 * out.data.size() > worth_threads)
  for (int ky = 0; ky < out.mh; ++ky) {
    const double* in = traction.data() + ky * transform_->row_size();
    const double* quarter =
        spectra.data() + static_cast<std::size_t>(ky) * out.components * nz * hx;
    for (int c = 0; c < out.components; ++c) {
      for (int k = 0; k < nz; ++k, quarter += hx) {
        add_parity_product(quarter, parity(kind, places[c]), scale, in, out.row(ky, c, k),
                           *transform_);
      }
    }
  }
  out.used.assign(nz, 1);
}

std::size_t TractionStress::bytes() const {
  return (spectra_[0].size() + spectra_[1].size() + spectra_[2].size()) * sizeof(double);
}

Field traction_stress(const Grid& grid, double nu, std::span<const double> depths,
                      const double* pressure, const double* shear_x, const double* shear_y) {
  const VolumeTransform transform(grid.nx, grid.ny, Symmetry::none);
  const std::array<const double*, 3> tractions{pressure, shear_x, shear_y};
  Field stress(6 * depths.size() * grid.surface_size());
  const std::size_t plane = grid.surface_size();
  // One depth at a time: the kernels of a depth are used once, so only one set is kept.
  for (std::size_t d = 0; d < depths.size(); ++d) {
    TractionStress single(grid, transform, nu, {depths[d]}, Tensor::full);
    VolumeSpectrum spectrum(transform, 1, Tensor::full);
    for (int kind = 0; kind < 3; ++kind) {
      if (tractions[kind] == nullptr) continue;
      single.prepare(static_cast<Traction>(kind));
      single.add(static_cast<Traction>(kind), transform.forward(tractions[kind]), 1.0, spectrum);
    }
    Field layer(6 * plane);
    inverse(transform, spectrum, layer.data());
    for (int c = 0; c < 6; ++c) {
      std::copy(layer.begin() + c * plane, layer.begin() + (c + 1) * plane,
                stress.begin() + (c * depths.size() + d) * plane);
    }
  }
  return stress;
}

}  // namespace samcontact::operators
