// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/traction_stress.hpp"

#include <algorithm>
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
  const bool both = kind == Traction::heat_xy;
  if (kind == Traction::shear_x || kind == Traction::heat_x || both) p.odd_x = !p.odd_x;
  if (kind == Traction::shear_y || kind == Traction::heat_y || both) p.odd_y = !p.odd_y;
  return p;
}

/// Index in ParityParts of the heat that belongs to a kind.
int heat_part(Traction kind) {
  if (kind == Traction::pressure) return 0;
  return static_cast<int>(kind) - static_cast<int>(Traction::heat_x) + 1;
}

bool is_shear(Traction kind) { return kind == Traction::shear_x || kind == Traction::shear_y; }

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

/// Adds a table [j][i] of the grid's offsets, if there is one, to a wider quarter.
void add_table(const Field& table, const Grid& grid, double* quarter, int hx) {
  for (std::size_t n = 0; n < table.size(); ++n) {
    quarter[n / grid.nx * hx + n % grid.nx] += table[n];
  }
}

}  // namespace

TractionStress::TractionStress(const Grid& grid, const VolumeTransform& transform,
                               const Elastic& elastic, std::shared_ptr<const HeatStress> heat,
                               std::vector<double> depths, Tensor tensor)
    : grid_(grid),
      transform_(&transform),
      elastic_(elastic),
      heat_(std::move(heat)),
      depths_(std::move(depths)),
      tensor_(tensor) {}

std::vector<Traction> TractionStress::pressure_kinds() const {
  std::vector<Traction> kinds{Traction::pressure};
  if (!heat_) return kinds;
  if (heat_->heating().speed_x != 0) kinds.push_back(Traction::heat_x);
  if (heat_->heating().speed_y != 0) kinds.push_back(Traction::heat_y);
  if (kinds.size() == 3) kinds.push_back(Traction::heat_xy);
  return kinds;
}

TractionStress::HeatTables TractionStress::heat_tables(double z) const {
  auto stress = heat_->at(z, grid_);
  if (tensor_ == Tensor::deviator) {
    for (int part = 0; part < 4; ++part) {
      Field &xx = stress[0][part], &yy = stress[1][part];
      const Field& zz = stress[2][part];
      for (std::size_t n = 0; n < xx.size(); ++n) {
        const double mean = (xx[n] + yy[n] + (zz.empty() ? 0.0 : zz[n])) / 3;
        xx[n] -= mean;
        yy[n] -= mean;
      }
    }
  }
  HeatTables tables;
  for (const int c : components(tensor_)) tables.push_back(std::move(stress[c]));
  return tables;
}

void TractionStress::prepare(Traction kind) {
  if (!spectra_[static_cast<int>(kind)].empty()) return;
  if (is_shear(kind)) return build(kind, {});
  std::vector<HeatTables> heat;
  if (heat_) {
    // Not in parallel: a table asks whether to stop, and may throw.
    for (const double z : depths_) heat.push_back(heat_tables(z));
  }
  for (const Traction part : pressure_kinds()) build(part, heat);
}

void TractionStress::build(Traction kind, const std::vector<HeatTables>& heat) {
  const fft::ParitySpectrum parity_spectrum(transform_->mx(), transform_->my());
  const CornerLattice lattice{grid_.nx, grid_.ny, grid_.dy / grid_.dx};
  const int nz = layers(), hx = parity_spectrum.hx(), hy = parity_spectrum.hy();
  const auto places = components(tensor_);
  const int count = static_cast<int>(places.size());
  const bool elastic = kind == Traction::pressure || is_shear(kind);
  Field built(parity_spectrum.size() * count * nz);
  check_interrupt();
#pragma omp parallel
  {
    Field corners(elastic ? 6 * lattice.size() : 0), quarter(parity_spectrum.size());
#pragma omp for schedule(dynamic)
    for (int k = 0; k < nz; ++k) {
      const double z = depths_[k] / grid_.dx;
      if (elastic) {
        const double nu = elastic_.nu;
        lattice.evaluate<6>(
            [&](double x, double y) {
              auto s = select(corner_stress(kind, x, y, z, nu), tensor_);
              for (double& v : s) v /= 2 * std::numbers::pi;
              return s;
            },
            corners.data());
      }
      for (int c = 0; c < count; ++c) {
        std::fill(quarter.begin(), quarter.end(), 0.0);
        if (elastic) {
          lattice.corner_sums(corners.data() + c * lattice.size(), quarter.data(), hx, hy);
        }
        if (!heat.empty()) add_table(heat[k][c][heat_part(kind)], grid_, quarter.data(), hx);
        const auto p = parity(kind, places[c]);
        parity_spectrum.transform(quarter.data(), p.odd_x, p.odd_y);
        for (int ky = 0; ky < hy; ++ky) {
          std::copy_n(quarter.data() + static_cast<std::size_t>(ky) * hx, hx,
                      built.data() + ((static_cast<std::size_t>(ky) * count + c) * nz + k) * hx);
        }
      }
    }
  }
  spectra_[static_cast<int>(kind)] = std::move(built);
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
  std::size_t values = 0;
  for (const Field& spectrum : spectra_) values += spectrum.size();
  return values * sizeof(double);
}

Field traction_stress(const Grid& grid, const Elastic& elastic, const Heating& heating,
                      std::span<const double> depths, const double* pressure, const double* shear_x,
                      const double* shear_y) {
  const VolumeTransform transform(grid.nx, grid.ny, Symmetry::none);
  const auto heat =
      heating.is_on() ? std::make_shared<const HeatStress>(grid, elastic, heating) : nullptr;
  Field stress(6 * depths.size() * grid.surface_size());
  const std::size_t plane = grid.surface_size();
  // One depth at a time: the kernels of a depth are used once, so only one set is kept.
  for (std::size_t d = 0; d < depths.size(); ++d) {
    TractionStress single(grid, transform, elastic, heat, {depths[d]}, Tensor::full);
    VolumeSpectrum spectrum(transform, 1, Tensor::full);
    const auto add = [&](const double* traction, Traction kind) {
      if (traction == nullptr) return;
      single.prepare(kind);
      single.add(kind, transform.forward(traction), 1.0, spectrum);
    };
    for (const Traction kind : single.pressure_kinds()) add(pressure, kind);
    add(shear_x, Traction::shear_x);
    add(shear_y, Traction::shear_y);
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
