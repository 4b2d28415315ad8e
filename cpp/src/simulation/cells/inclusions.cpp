// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/inclusions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace samcontact::simulation {
namespace {

using plasticity::MixedCell;

/// Moduli and shares of cells on both sides of a mirror plane may differ by image_rounding errors.
constexpr double image_rounding = 1e-10;

/// Ratio of moduli beyond which the strain of inclusions converges slowly.
constexpr double large_ratio = 20.0;

bool is_image(const MixedCell* a, const MixedCell* b) {
  if (a == nullptr || b == nullptr) return a == b;
  const auto near = [](double x, double y) {
    return std::fabs(x - y) <= image_rounding * std::max(std::fabs(x), std::fabs(y));
  };
  // Shear components of the misfit change their sign: without them there is an image.
  for (int c = 0; c < 3; ++c) {
    if (!near(std::fabs(a->normal[c]), std::fabs(b->normal[c]))) return false;
  }
  return near(a->bulk, b->bulk) && near(a->shear, b->shear) && near(a->share, b->share) &&
         a->material == b->material && near(a->expansion, b->expansion) &&
         near(a->misfit[0], b->misfit[0]) && near(a->misfit[1], b->misfit[1]) &&
         near(a->misfit[2], b->misfit[2]) &&
         std::all_of(a->misfit.begin() + 3, a->misfit.end(), [](double v) { return v == 0; });
}

}  // namespace

Inclusions::Inclusions(const Box& box, int k0, std::vector<std::int32_t> number,
                       std::vector<MixedCell> cells, Materials materials)
    : box_(box),
      k0_(k0),
      number_(std::move(number)),
      cells_(std::move(cells)),
      materials_(std::move(materials)) {
  if (number_.size() != box_.volume_size()) {
    throw std::invalid_argument("the cells of the inclusions do not match their box");
  }
  has_misfit_ = std::any_of(cells_.begin(), cells_.end(), [](const MixedCell& cell) {
    return cell.misfit != plasticity::Tensor{};
  });
  expand_ = std::any_of(cells_.begin(), cells_.end(),
                        [](const MixedCell& cell) { return cell.expansion != 0; });
  const auto is_strong = [](double ratio) {
    return ratio < 1 / large_ratio || ratio > large_ratio;
  };
  strong_ = std::any_of(cells_.begin(), cells_.end(), [&](const MixedCell& cell) {
    return is_strong(cell.bulk) || is_strong(cell.shear);
  });
}

Box Inclusions::in_grid(const Grid& grid, int first) const {
  if (grid.period.x > 0) {
    return {0, box_.j0, grid.nx, box_.ny, k0_ + box_.nz, k0_};
  }
  const int begin = std::max(0, box_.i0 - first);
  const int end = std::min(grid.nx, box_.i0 + box_.nx - first);
  if (begin >= end) return {};
  return {begin, box_.j0, end - begin, box_.ny, k0_ + box_.nz, k0_};
}

fft::Symmetry Inclusions::symmetry(const Grid& grid) const {
  const auto mirrored = [&](bool along_x) {
    for (int k = k0_; k < k0_ + box_.nz; ++k) {
      for (int i = box_.i0; i < box_.i0 + box_.nx; ++i) {
        for (int j = box_.j0; j < box_.j0 + box_.ny; ++j) {
          const int mi = along_x ? grid.nx - 1 - i : i, mj = along_x ? j : grid.ny - 1 - j;
          const Period& period = grid.period;
          if (!is_image(at(i, j, k, 0, period), at(mi, mj, k, 0, period))) return false;
        }
      }
    }
    return true;
  };
  if (!mirrored(false)) return fft::Symmetry::none;
  return mirrored(true) ? fft::Symmetry::xy : fft::Symmetry::y;
}

std::size_t Inclusions::bytes() const {
  return number_.size() * sizeof(std::int32_t) + cells_.size() * sizeof(MixedCell);
}

}  // namespace samcontact::simulation
