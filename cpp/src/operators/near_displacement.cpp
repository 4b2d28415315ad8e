// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/near_displacement.hpp"

#include <algorithm>
#include <array>

#include "samcontact/base/threads.hpp"

namespace samcontact::operators {
namespace {

/// Shorter boxes are padded in full: their coarse grid would be as fine as the box.
constexpr int shortest_side = 64;
/// Coarse cells along a box; eight of them fit into the shortest distance across the seam.
constexpr int coarse_count = 64;

bool padded_in_full(int nx, int ny) { return std::min(nx, ny) < shortest_side; }

int with_margin(int cells) { return cells + (cells + 7) / 8; }

fft::PeriodicTransform transform_for(const Grid& box) {
  const auto [nx, ny] = std::array{box.nx, box.ny};
  if (!padded_in_full(nx, ny)) return {nx, ny, short_period_x(box), short_period_y(box)};
  return {nx, ny, fft::convolution_size(nx, box.period.x), fft::convolution_size(ny, box.period.y)};
}

/// Whether a period of so many points is one of the surface, or longer than any distance.
bool is_exact_period(int size, int cells, int period) {
  return size == period || size >= 2 * cells - 1;
}

/// A period that the surface has is best, where it is not too long.
int choose_period(int size, int period) {
  return period > 0 && period % 2 == 0 && period <= size ? period : size;
}

int coarse_factor(int cells) { return std::max(2, cells / coarse_count); }

}  // namespace

int short_period_x(const Grid& box) {
  return choose_period(fft::fast_line_size(with_margin(box.nx)), box.period.x);
}

int short_period_y(const Grid& box) {
  return choose_period(fft::fast_row_size(with_margin(box.ny)), box.period.y);
}

Field periodic_spectrum(const fft::PeriodicTransform& transform, const Grid& box,
                        const std::function<Field(const CellOffsets&)>& influence) {
  // A single cell that repeats itself has one offset, and empty cells beside it.
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

int CoarseAxis::lower(int i) const {
  return std::clamp((2 * i + 1 - factor) / (2 * factor), 0, coarse_cells() - 2);
}

double CoarseAxis::weight(int i, int I) const {
  const double beyond = (i + 0.5) / factor - 0.5 - lower(i);
  return I == lower(i) ? 1.0 - beyond : I == lower(i) + 1 ? beyond : 0.0;
}

int CoarseAxis::begin(int I) const { return std::max((I - 1) * factor, 0); }

int CoarseAxis::end(int I) const { return std::min((I + 2) * factor, cells); }

NearDisplacement::NearDisplacement(const Grid& box, const SurfaceInfluence& influence)
    : transform_(transform_for(box)),
      near_(periodic_spectrum(
          transform_, box,
          [&](const CellOffsets& offsets) { return influence.even(box, offsets); })),
      x_{box.nx, coarse_factor(box.nx)},
      y_{box.ny, coarse_factor(box.ny)} {
  const int nx = box.nx, ny = box.ny;
  if (is_exact_period(transform_.mx(), nx, box.period.x) &&
      is_exact_period(transform_.my(), ny, box.period.y)) {
    return;
  }

  y_begin_.assign(y_.coarse_cells(), ny);
  for (int j = ny - 1; j >= 0; --j) y_begin_[y_.lower(j)] = j;
  for (int j = 0; j < ny; ++j) y_share_.push_back(y_.weight(j, y_.lower(j) + 1));
  const int cx = x_.coarse_cells(), cy = y_.coarse_cells();
  far_transform_ = std::make_unique<fft::PeriodicTransform>(cx, cy, fft::good_even_size(2 * cx - 1),
                                                            fft::good_even_size(2 * cy - 1));
  const int hx = far_transform_->hx();
  far_.assign(far_transform_->quarter_size(), 0.0);
  CellOffsets direct, nearest;  // to the cell, and to the nearest of its images
  for (int I = 0; I < cx; ++I) {
    const int x = I * x_.factor;
    direct.x.push_back(x);
    nearest.x.push_back(std::min(x, transform_.mx() - x));
  }
  for (int J = 0; J < cy; ++J) {
    const int y = J * y_.factor;
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
  if (far_transform_) add_far(pressure, displacement, work);
}

double NearDisplacement::cost() const {
  return transform_.cost() + (far_transform_ ? far_transform_->cost() : 0.0);
}

void NearDisplacement::add_far(const double* pressure, double* displacement,
                               ComplexField& work) const {
  const int nx = x_.cells, ny = y_.cells, cx = x_.coarse_cells(), cy = y_.coarse_cells();
  Field rows(static_cast<std::size_t>(nx) * cy), coarse(static_cast<std::size_t>(cx) * cy, 0.0);
  // Threads gather, each row for itself, so that no sum depends on their number.
#pragma omp parallel for schedule(static) if (static_cast<std::ptrdiff_t>(nx) * ny >= \
                                                  worth_threads_cells)
  for (int i = 0; i < nx; ++i) {
    const double* p = pressure + static_cast<std::size_t>(i) * ny;
    double* row = rows.data() + static_cast<std::size_t>(i) * cy;
    for (int J = 0; J + 1 < cy; ++J) {
      double all = 0.0, above = 0.0;
      for (int j = y_begin_[J]; j < y_begin_[J + 1]; ++j) {
        all += p[j];
        above += y_share_[j] * p[j];
      }
      row[J] += all - above;
      row[J + 1] += above;
    }
  }
  for (int I = 0; I < cx; ++I) {
    double* sum = coarse.data() + static_cast<std::size_t>(I) * cy;
    for (int i = x_.begin(I); i < x_.end(I); ++i) {
      const double* row = rows.data() + static_cast<std::size_t>(i) * cy;
      const double w = x_.weight(i, I);
      for (int J = 0; J < cy; ++J) sum[J] += w * row[J];
    }
  }
  far_transform_->filter(coarse.data(), far_.data(), coarse.data(), work);
#pragma omp parallel for schedule(static) if (static_cast<std::ptrdiff_t>(nx) * ny >= \
                                                  worth_threads_cells)
  for (int i = 0; i < nx; ++i) {
    const double* from = coarse.data() + static_cast<std::size_t>(x_.lower(i)) * cy;
    const double w0 = x_.weight(i, x_.lower(i)), w1 = 1.0 - w0;
    double* row = rows.data() + static_cast<std::size_t>(i) * cy;
    for (int J = 0; J < cy; ++J) row[J] = w0 * from[J] + w1 * from[J + cy];
    double* u = displacement + static_cast<std::size_t>(i) * ny;
    for (int J = 0; J + 1 < cy; ++J) {
      const double here = row[J], rise = row[J + 1] - row[J];
      for (int j = y_begin_[J]; j < y_begin_[J + 1]; ++j) u[j] += here + y_share_[j] * rise;
    }
  }
}

}  // namespace samcontact::operators
