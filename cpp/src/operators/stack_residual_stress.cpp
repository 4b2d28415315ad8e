// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/stack_residual_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/flush_denormals.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/image_correction.hpp"
#include "samcontact/operators/stack_sweep.hpp"
#include "samcontact/operators/wave_aliases.hpp"

namespace samcontact::operators {
namespace {

/// How far from a face of cells an interface may lie, in layers of cells.
constexpr double off_face = 1e-6;

std::vector<int> layers_of_cells(const Grid& grid, const Stack& stack) {
  double depth = 0.0;
  for (std::size_t n = 0; n < stack.layers.size(); ++n) {
    depth += stack.layers[n].thickness;
    const double cells = depth / grid.dz;
    if (cells > grid.nz + off_face || std::fabs(cells - std::round(cells)) < off_face) continue;
    throw std::invalid_argument("the bottom of layers[" + std::to_string(n) + "], at " +
                                to_text(depth) + " m, must lie between layers of cells, got dz = " +
                                to_text(grid.dz) + " m: take a part of the thickness");
  }
  std::vector<int> found;
  found.reserve(grid.nz);
  for (int k = 0; k < grid.nz; ++k) found.push_back(stack.layer_at((k + 0.5) * grid.dz));
  return found;
}

const Elastic& elastic_of_images(const Stack& stack) {
  return stack.substrate.is_rigid() ? stack.layers.back().elastic : stack.substrate;
}

/// Numbers of a wavenumber in a spectrum: six components in the frame of the grid.
using Six = std::array<double, 6>;

/// v: xx, yy, zz, yz, xz, xy of the strain; c, s: direction of the wave.
TurnedTensor eigenstress(const Six& v, double c, double s, double lame, double twice_mu) {
  const double trace = lame * (v[0] + v[1] + v[2]);
  const double xx = c * v[0] + s * v[5], xy = c * v[5] + s * v[1];
  const double yx = c * v[5] - s * v[0], yy = c * v[1] - s * v[5];
  return {trace + twice_mu * (c * xx + s * xy),
          trace + twice_mu * (c * yy - s * yx),
          trace + twice_mu * v[2],
          twice_mu * (c * xy - s * xx),
          twice_mu * (c * v[4] + s * v[3]),
          twice_mu * (c * v[3] - s * v[4])};
}

Six turned_back(const TurnedTensor& t, double c, double s, bool deviator) {
  const double ax = c * t.t11 - s * t.t12, ay = c * t.t12 - s * t.t22;
  const double bx = s * t.t11 + c * t.t12, by = s * t.t12 + c * t.t22;
  Six v{c * ax - s * ay,       s * bx + c * by,       t.t33,
        s * t.t13 + c * t.t23, c * t.t13 - s * t.t23, s * ax + c * ay};
  if (deviator) {
    const double mean = (t.t11 + t.t22 + t.t33) / 3;
    v[0] -= mean;
    v[1] -= mean;
  }
  return v;
}

/// One stored wavenumber of a spectrum, its numbers times powers of i that make them real in the
/// turned frame.
class StoredWave {
 public:
  explicit StoredWave(VolumeSpectrum& spectrum) : spectrum_(&spectrum) {
    for (int c = 0; c < 6; ++c) {
      const auto parity = kernels::component_parity(c);
      const int missing = (spectrum.symmetry != Symmetry::none && parity.odd_y) +
                          (spectrum.symmetry == Symmetry::xy && parity.odd_x);
      turns_[c] = ((c == 3 || c == 4) + 3 * missing) % 4;
    }
  }

  /// [part][layer].
  void load(int ky, int kx, std::array<std::vector<Six>, 2>& values) const {
    for (int k = 0; k < spectrum_->nz; ++k) {
      for (int p = 0; p < spectrum_->parts; ++p) values[p][k] = {};
      if (!spectrum_->used[k]) continue;
      for_components(ky, kx, k, [&](int m, double* stored) {
        const auto number = turned(stored, turns_[m]);
        for (int p = 0; p < spectrum_->parts; ++p) values[p][k][m] = number[p];
      });
      if (spectrum_->tensor == Tensor::full) continue;
      for (int p = 0; p < spectrum_->parts; ++p) {
        values[p][k][2] = -(values[p][k][0] + values[p][k][1]);
      }
    }
  }
  void store(int ky, int kx, const std::array<std::vector<Six>, 2>& values) const {
    for (int k = 0; k < spectrum_->nz; ++k) {
      for_components(ky, kx, k, [&](int m, double* stored) {
        const double both[2] = {values[0][k][m], spectrum_->parts > 1 ? values[1][k][m] : 0.0};
        const auto number = turned(both, 4 - turns_[m]);
        for (int p = 0; p < spectrum_->parts; ++p) stored[p] = number[p];
      });
    }
  }

 private:
  template <class Visit>
  void for_components(int ky, int kx, int layer, const Visit& visit) const {
    const auto places = components(spectrum_->tensor);
    for (std::size_t c = 0; c < places.size(); ++c) {
      visit(places[c], spectrum_->row(ky, static_cast<int>(c), layer) +
                           static_cast<std::ptrdiff_t>(kx) * spectrum_->parts);
    }
  }
  /// Times i^turns; real numbers are turned by halves only.
  std::array<double, 2> turned(const double* number, int turns) const {
    const double sign = (turns & 2) != 0 ? -1.0 : 1.0;
    if (spectrum_->parts == 1) return {sign * number[0], 0.0};
    if ((turns & 1) == 0) return {sign * number[0], sign * number[1]};
    return {-sign * number[1], sign * number[0]};
  }

  VolumeSpectrum* spectrum_;
  std::array<int, 6> turns_{};
};

}  // namespace

StackResidualStress::StackResidualStress(const Grid& grid, const VolumeTransform& transform,
                                         const Stack& stack, const ResidualSettings& settings)
    : grid_(grid),
      transform_(&transform),
      stack_(stack),
      share_(settings.share),
      layer_of_(layers_of_cells(grid, stack)) {
  if (grid.period.x > 0 && grid.period.y > 0) return;
  if (grid.period.is_on()) {
    throw std::invalid_argument(
        "a layered body has no stress of plastic strain where one direction alone is periodic: "
        "give a grid that is periodic in both, or in none");
  }
  images_ = std::make_shared<ImageCorrection>(grid, transform, elastic_of_images(stack),
                                              settings.image_tol);
}

void StackResidualStress::apply(VolumeSpectrum& spectrum) const {
  // The transform is not normalised.
  const double unit_cell = 1.0 / (static_cast<double>(spectrum.mx) * spectrum.my);
  const bool deviator = spectrum.tensor == Tensor::deviator;
  const StoredWave stored(spectrum);
#pragma omp parallel if (per_number * spectrum.data.size() > worth_threads)
  {
    const FlushDenormals flush;
    StackSweep sweep(stack_, layer_of_, grid_.dz);
    std::array<std::vector<Six>, 2> strain, stress;
    for (auto* values : {&strain, &stress}) {
      for (auto& part : *values) part.resize(spectrum.nz);
    }
    std::vector<TurnedTensor> turned(spectrum.nz);
#pragma omp for schedule(dynamic)
    for (int ky = 0; ky < spectrum.mh; ++ky) {
      for (int kx = 0; kx < spectrum.modes; ++kx) {
        stored.load(ky, kx, strain);
        for (auto& part : stress) std::fill(part.begin(), part.end(), Six{});
        for (const int alias : {0, 1, 2, 3}) {
          const auto wave =
              wave_alias(grid_, *transform_, kx, ky, (alias & 1) != 0, (alias & 2) != 0, share_);
          if (!wave || wave->share == 0) continue;
          const double q = std::hypot(wave->kx, wave->ky);
          const double c = q > 0 ? wave->kx / q : 1.0, s = q > 0 ? wave->ky / q : 0.0;
          sweep.set_wavenumber(q);
          for (int p = 0; p < spectrum.parts; ++p) {
            for (int k = 0; k < spectrum.nz; ++k) {
              const Elastic& elastic = stack_.elastic(layer_of_[k]);
              const double mu = elastic.shear_modulus() * unit_cell * wave->share;
              turned[k] = eigenstress(strain[p][k], c, s,
                                      2 * mu * elastic.nu / (1 - 2 * elastic.nu), 2 * mu);
            }
            sweep.apply(turned);
            for (int k = 0; k < spectrum.nz; ++k) {
              const Six back = turned_back(turned[k], c, s, deviator);
              for (int m = 0; m < 6; ++m) stress[p][k][m] += back[m];
            }
          }
        }
        stored.store(ky, kx, stress);
      }
    }
  }
  spectrum.used.assign(spectrum.nz, 1);
}

Field StackResidualStress::far_field(Tensor tensor, const double* strain) const {
  return images_ ? images_->stress(tensor, strain) : Field();
}

void StackResidualStress::correct(Tensor tensor, const Field& far_field, int layer,
                                  double* stress) const {
  if (images_) images_->subtract(tensor, far_field, layer, stress);
}

}  // namespace samcontact::operators
