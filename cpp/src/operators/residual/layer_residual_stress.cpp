// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/layer_residual_stress.hpp"

#include <algorithm>

#include "samcontact/base/flush_denormals.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/residual/image_correction.hpp"
#include "samcontact/operators/residual/layer_sweep.hpp"
#include "samcontact/operators/residual/line_images.hpp"
#include "samcontact/operators/residual/wave_aliases.hpp"

namespace samcontact::operators {
namespace {

using layers::width;

/// With yz and xz multiplied by i all numbers are real; stored spectra lack a factor (-i) for each
/// mirrored direction in which the component is odd.
layers::Layout make_layout(const VolumeSpectrum& spectrum) {
  layers::Layout at{spectrum.nz,
                    spectrum.tensor == Tensor::deviator,
                    {},
                    spectrum.nz * spectrum.row_size(),
                    spectrum.row_size()};
  for (int c = 0; c < 6; ++c) {
    const auto parity = kernels::component_parity(c);
    const int missing = (spectrum.symmetry != Symmetry::none && parity.odd_y) +
                        (spectrum.symmetry == Symmetry::xy && parity.odd_x);
    at.turns[c] = ((c == 3 || c == 4) + 3 * missing) % 4;
  }
  return at;
}

/// Layout of one block alone, one layer after the other.
layers::Layout block_layout(const layers::Layout& of, int parts) {
  layers::Layout at = of;
  at.component_step = static_cast<std::size_t>(width) * parts;
  at.layer_step = 6 * at.component_step;
  return at;
}

}  // namespace

LayerResidualStress::LayerResidualStress(const Grid& grid, const VolumeTransform& transform,
                                         const Stack& body, const ResidualSettings& settings)
    : LayerResidualStress(grid, transform, body, settings.share, settings.blends) {
  const double image_tol = settings.image_tol;
  const bool along_x = grid.period.x > 0, along_y = grid.period.y > 0;
  if (along_x && along_y) return;
  if (along_x || along_y) {
    images_ = std::make_shared<LineImages>(grid, transform, body, image_tol);
  } else {
    images_ = std::make_shared<ImageCorrection>(grid, transform, body, image_tol);
  }
}

LayerResidualStress::LayerResidualStress(const Grid& grid, const VolumeTransform& transform,
                                         const Stack& body, const Share& share, bool blends)
    : stack_(body, grid.k0, grid.nz, grid.dz) {
  for (int ky = 0; ky < transform.mh(); ++ky) {
    passes_.push_back(passes(grid, transform, ky, share, blends));
  }
}

std::vector<LayerResidualStress::Pass> LayerResidualStress::passes(const Grid& grid,
                                                                   const VolumeTransform& transform,
                                                                   int ky, const Share& share,
                                                                   bool blends) const {
  if (!blends) {
    return {pass(grid, transform, ky, false, false, share, blends)};
  }
  std::vector<Pass> found;
  for (const bool alias_y : {false, true}) {
    if (alias_y && 2 * ky <= blended_from * transform.my()) continue;
    for (const bool alias_x : {false, true}) {
      found.push_back(pass(grid, transform, ky, alias_x, alias_y, share, blends));
    }
  }
  return found;
}

LayerResidualStress::Pass LayerResidualStress::pass(const Grid& grid,
                                                    const VolumeTransform& transform, int ky,
                                                    bool alias_x, bool alias_y, const Share& share,
                                                    bool blends) const {
  int first = transform.modes(), last = 0;
  for (int i = 0; i < transform.modes(); ++i) {
    if (!wave_alias(grid, transform, i, ky, alias_x, alias_y, {}, blends)) continue;
    first = std::min(first, i);
    last = i + 1;
  }
  Pass found{first / width * width, (last + width - 1) / width * width, {}};
  if (found.last <= found.first) return {};
  const int step = found.last - found.first;
  found.modes.assign(static_cast<std::size_t>(step) * stack_.numbers(), 0.0);
  // The transform is not normalised.
  const double unit_cell = 1.0 / (static_cast<double>(transform.mx()) * transform.my());
  for (int i = found.first; i < std::min(found.last, transform.modes()); ++i) {
    // Positions of a block outside the first and the last wavenumber have weight 0.
    const auto wave = wave_alias(grid, transform, i, ky, alias_x, alias_y, share, blends);
    if (!wave) continue;
    stack_.fill_mode(wave->kx, wave->ky, wave->share * unit_cell,
                     found.modes.data() + i - found.first, step);
  }
  return found;
}

void LayerResidualStress::apply(VolumeSpectrum& spectrum) const {
  const layers::Layout layout = make_layout(spectrum), block = block_layout(layout, spectrum.parts);
#pragma omp parallel if (per_number * spectrum.data.size() > min_parallel_operations)
  {
    const FlushDenormals flush;
    layers::Scratch scratch(stack_, spectrum.parts);
    Field aliases(spectrum.nz * block.layer_step);
#pragma omp for schedule(dynamic)
    for (int ky = 0; ky < spectrum.mh; ++ky) {
      for (int kx = 0; kx < spectrum.modes; kx += width) {
        double* values = spectrum.row(ky, 0, 0) + static_cast<std::ptrdiff_t>(kx) * spectrum.parts;
        const double* added = nullptr;
        // The first pass, that of the wavenumbers themselves, is last: it replaces the strain.
        for (auto pass = passes_[ky].rbegin(); pass != passes_[ky].rend(); ++pass) {
          if (kx < pass->first || kx >= pass->last) continue;
          const bool is_own = std::next(pass) == passes_[ky].rend();
          const layers::Target target{is_own ? layout : block, is_own ? values : aliases.data(),
                                      block, added};
          layers::sweep(stack_, spectrum.parts, layout, spectrum.used.data(),
                        pass->modes.data() + (kx - pass->first), pass->last - pass->first, values,
                        target, scratch);
          added = aliases.data();
        }
      }
    }
  }
  spectrum.used.assign(spectrum.nz, 1);
}

Field LayerResidualStress::far_field(Tensor tensor, const double* strain) const {
  return images_ ? images_->stress(tensor, strain) : Field();
}

void LayerResidualStress::correct(Tensor tensor, const Field& far_field, int layer,
                                  double* stress) const {
  if (images_) images_->subtract(tensor, far_field, layer, stress);
}

std::size_t LayerResidualStress::bytes() const {
  std::size_t numbers = 0;
  for (const auto& passes : passes_) {
    for (const Pass& pass : passes) numbers += pass.modes.size();
  }
  return numbers * sizeof(double) + (images_ ? images_->bytes() : 0);
}

}  // namespace samcontact::operators
