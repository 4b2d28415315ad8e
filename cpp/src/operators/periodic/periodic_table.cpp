// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/periodic/periodic_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace samcontact::operators {
namespace {

/// Distance in periods along y beyond which a row of loads is equivalent to a uniform strip: exp(-2
/// pi 6).
constexpr double uniform_from = 6.0;

/// First offsets of a period and their images: `near_images` images to each side are added one by
/// one.
template <class Visit>
void for_each_image(const LatticeAxis& axis, int cells, int i, const Visit& visit) {
  for (int n = -axis.near_images; n <= axis.near_images; ++n) visit(i + n * cells);
}

double sign_of(bool odd, int offset) { return odd && offset < 0 ? -1.0 : 1.0; }

}  // namespace

bool PeriodicTable::is_direct(const Grid& grid) {
  const Period& period = grid.period;
  if (period.x == 0 || period.y == 0) return period.y > 0;
  if (period.x == 1 || period.y == 1) return period.y == 1;
  return period.y * grid.dy <= period.x * grid.dx;
}

bool PeriodicTable::fits(double dx, double dy, const Period& period, int cells_x, int step) const {
  return x_.d == dx && y_.d == dy && x_.length == dx / step && period_ == period &&
         (period.x > 0 || x_.cells == cells_x);
}

PeriodicTable::PeriodicTable(double dx, double dy, const Period& period, int cells_x, int step,
                             const PeriodicTable* like)
    : period_(period),
      x_{dx, period.x > 0 ? period.x / 2 + 1 : cells_x, period.x * dx, dx / step},
      near_x_(x_),
      y_{dy, period.y / 2 + 1, period.y * dy, dy / step} {
  if (period.y > 1) {
    const bool square = period.x > 0 && x_.extent() <= uniform_from * y_.period;
    if (!square) {
      near_x_.period = 0;
      near_x_.cells =
          std::min(x_.cells, static_cast<int>(std::floor(uniform_from * y_.period / dx + 0.5)) + 1);
    }
    // Images so near that the remainder would vary faster than over the offsets.
    const double smooth = std::max(near_x_.extent(), y_.extent());
    while (near_x_.period > 0 && near_x_.distance() < 0.99 * smooth) ++near_x_.near_images;
    while (y_.distance() < 0.99 * smooth) ++y_.near_images;
    cell_images_ = std::make_unique<LatticeImages>(
        LatticeImages::of_cells(near_x_, y_, like ? like->cell_images_.get() : nullptr));
    if (square) return;
  }
  if (period.x > 1) strip_images_ = std::make_unique<LatticeImages>(LatticeImages::of_strips(x_));
}

Field PeriodicTable::near_sum(const CellInfluence& influence) const {
  const int nx = near_x_.cells, ny = y_.cells;
  const int wide = nx + near_x_.near_images * period_.x, high = ny + y_.near_images * period_.y;
  const Field cell = influence.cell(wide, high);
  const std::size_t count = influence.parities.size();
  Field sum(count * nx * ny, 0.0);
  double* to = sum.data();
  for (std::size_t c = 0; c < count; ++c) {
    const auto& [odd_x, odd_y, odd_z] = influence.parities[c];
    const double* from = cell.data() + c * wide * high;
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i, ++to) {
        for_each_image(y_, period_.y, j, [&, odd_x = odd_x, odd_y = odd_y](int y) {
          for_each_image(near_x_, period_.x, i, [&](int x) {
            *to += sign_of(odd_x, x) * sign_of(odd_y, y) *
                   from[static_cast<std::size_t>(std::abs(y)) * wide + std::abs(x)];
          });
        });
      }
    }
  }
  cell_images_->add(influence.wave, influence.parities, sum);
  return sum;
}

namespace {

/// Number of cells of a period at this offset or at its mirror image.
double multiplicity(int offset, int period) {
  return offset == 0 || 2 * offset == period ? 1.0 : 2.0;
}

}  // namespace

Field PeriodicTable::strips(const CellInfluence& influence) const {
  Field sum = influence.strip(x_.cells);
  if (period_.x == 0) return sum;
  const std::size_t count = influence.parities.size(), nx = x_.cells;
  if (strip_images_) {
    std::vector<kernels::Parity> parities = influence.parities;
    for (auto& parity : parities) parity.odd_y = false;
    strip_images_->add(influence.wave, parities, sum);
  }
  for (std::size_t c = 0; c < count; ++c) {
    double* values = sum.data() + c * nx;
    if (influence.parities[c].odd_y) std::fill_n(values, nx, 0.0);
    if (influence.parities[c].odd_x || influence.parities[c].odd_y) continue;
    double total = 0.0;
    for (std::size_t i = 0; i < nx; ++i) {
      total += multiplicity(static_cast<int>(i), period_.x) * values[i];
    }
    const double shift = (influence.uniform[c] - total) / period_.x;
    for (std::size_t i = 0; i < nx; ++i) values[i] += shift;
  }
  return sum;
}

Field PeriodicTable::sum(const CellInfluence& influence) const {
  if (period_.y == 1) return strips(influence);
  const std::size_t count = influence.parities.size(), nx = x_.cells, ny = y_.cells;
  const std::size_t near = near_x_.cells;
  const bool square = near_x_.period > 0;
  const Field cells = near_sum(influence);
  const Field rows = square ? Field() : strips(influence);
  Field table(count * nx * ny, 0.0);
  for (std::size_t c = 0; c < count; ++c) {
    const auto& parity = influence.parities[c];
    double* to = table.data() + c * nx * ny;
    const double* from = cells.data() + c * near * ny;
    for (std::size_t j = 0; j < ny; ++j) std::copy_n(from + j * near, near, to + j * nx);
    if (parity.odd_y) continue;
    // Constants that the images leave open: uniform loads, and rows of them, are known.
    double total = 0.0;
    for (std::size_t i = 0; i < nx; ++i) {
      double row = 0.0;
      for (std::size_t j = 0; j < ny && i < near; ++j) {
        row += multiplicity(static_cast<int>(j), period_.y) * to[j * nx + i];
      }
      if (square) {
        total += multiplicity(static_cast<int>(i), period_.x) * row;
        continue;
      }
      const double shift = (rows[c * nx + i] - row) / period_.y;
      for (std::size_t j = 0; j < ny; ++j) to[j * nx + i] += shift;
    }
    if (!square || parity.odd_x) continue;
    const double shift = (influence.uniform[c] - total) / (period_.x * period_.y);
    for (std::size_t n = 0; n < nx * ny; ++n) to[n] += shift;
  }
  return table;
}

}  // namespace samcontact::operators
