// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/near_displacement.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace samcontact::operators {
namespace {

/// Shorter boxes are padded in full: the coarse grid would take longer than the padding.
constexpr int shortest_side = 144;
int with_margin(int cells) { return cells + (cells + 7) / 8; }

fft::PeriodicTransform transform_for(const Grid& box) {
  const auto [nx, ny] = std::array{box.nx, box.ny};
  if (std::min(nx, ny) >= shortest_side) return {nx, ny, short_period_x(box), short_period_y(box)};
  return {nx, ny, fft::convolution_size(nx, box.period.x), fft::convolution_size(ny, box.period.y)};
}

/// The period of the surface is used if it is not too long.
int choose_period(int size, int period) {
  return period > 0 && period % 2 == 0 && period <= size ? period : size;
}

}  // namespace

bool is_exact_period(int size, int cells, int period) {
  return size == period || size >= 2 * cells - 1;
}

int short_period_x(const Grid& box) {
  return choose_period(fft::fast_line_size(with_margin(box.nx)), box.period.x);
}

int short_period_y(const Grid& box) {
  return choose_period(fft::fast_row_size(with_margin(box.ny)), box.period.y);
}

Field periodic_spectrum(const fft::PeriodicTransform& transform, const Grid& box,
                        const std::function<Field(const CellOffsets&)>& influence) {
  // A single cell that is repeated periodically has one offset, and empty cells next to it.
  const int nx = box.period.x == 1 ? 1 : transform.hx(),
            ny = box.period.y == 1 ? 1 : transform.hy();
  const Field table = influence(CellOffsets::lattice(nx, ny));
  Field quarter(transform.quarter_size(), 0.0);
  for (int j = 0; j < ny; ++j) {
    std::copy_n(table.data() + static_cast<std::size_t>(j) * nx, nx,
                quarter.data() + static_cast<std::size_t>(j) * transform.hx());
  }
  transform.spectrum(quarter.data());
  return quarter;
}

NearDisplacement::NearDisplacement(const Grid& box, const SurfaceInfluence& influence,
                                   SharedEndEffects ends)
    : transform_(transform_for(box)),
      near_(periodic_spectrum(
          transform_, box,
          [&](const CellOffsets& offsets) { return influence.even(box, offsets); })),
      coarse_(box.nx, box.ny),
      ends_(std::move(ends)) {
  const int nx = box.nx, ny = box.ny;
  if (is_exact_period(transform_.mx(), nx, box.period.x) &&
      is_exact_period(transform_.my(), ny, box.period.y)) {
    return;
  }

  const int cx = coarse_.x().coarse_cells(), cy = coarse_.y().coarse_cells();
  far_transform_ = std::make_unique<fft::PeriodicTransform>(cx, cy, fft::good_even_size(2 * cx - 1),
                                                            fft::good_even_size(2 * cy - 1));
  const int hx = far_transform_->hx();
  far_.assign(far_transform_->quarter_size(), 0.0);
  CellOffsets direct, nearest;  // to the cell, and to the nearest of its images
  for (int I = 0; I < cx; ++I) {
    const int x = I * coarse_.x().factor;
    direct.x.push_back(x);
    nearest.x.push_back(std::min(x, transform_.mx() - x));
  }
  for (int J = 0; J < cy; ++J) {
    const int y = J * coarse_.y().factor;
    direct.y.push_back(y);
    nearest.y.push_back(std::min(y, transform_.my() - y));
  }
  const Field exact = influence.even(box, direct), periodic = influence.even(box, nearest);
  for (int J = 0; J < cy; ++J) {
    for (int I = 0; I < cx; ++I) {
      if (nearest.x[I] == direct.x[I] && nearest.y[J] == direct.y[J]) continue;
      const std::size_t at = static_cast<std::size_t>(J) * cx + I;
      far_[static_cast<std::size_t>(J) * hx + I] = exact[at] - periodic[at];
    }
  }
  far_transform_->spectrum(far_.data());
}

void NearDisplacement::apply(const double* pressure, double* displacement,
                             ComplexField& work) const {
  transform_.filter(pressure, near_.data(), displacement, work);
  if (ends_) {
    const Field ends = ends_->displacement(pressure);
    for (std::size_t i = 0; i < ends.size(); ++i) displacement[i] += ends[i];
  }
  if (!far_transform_) return;
  Field sums(coarse_.size());
  coarse_.gather(pressure, sums.data());
  far_transform_->filter(sums.data(), far_.data(), sums.data(), work);
  coarse_.add(sums.data(), displacement);
}

double NearDisplacement::cost() const {
  return transform_.cost() + (far_transform_ ? far_transform_->cost() : 0.0) +
         (ends_ ? ends_->cost() : 0.0);
}

}  // namespace samcontact::operators
