// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/periodic/periodic_sums.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::operators {
namespace {

/// Number of cached tables: grids of one contact, the finest, coarser ones, and their boxes.
constexpr std::size_t max_tables = 8;

/// Offset in a period, and whether it is the mirror image of the given one; period 0: not periodic.
struct Folded {
  int offset;
  bool mirrored = false;
  Folded(int n, int period) : offset(period > 0 ? n % period : n) {
    if (period > 0 && 2 * offset > period) {
      offset = period - offset;
      mirrored = true;
    }
  }
};

/// Table of one component from offsets folded into `columns` columns.
void unfold(const double* table, int columns, const Period& period, const CellOffsets& offsets,
            const kernels::Parity& parity, double* out) {
  for (const int j : offsets.y) {
    const Folded y(j, period.y);
    for (const int i : offsets.x) {
      const Folded x(i, period.x);
      const bool negative = (x.mirrored && parity.odd_x) != (y.mirrored && parity.odd_y);
      const double value = table[static_cast<std::size_t>(y.offset) * columns + x.offset];
      *out++ = negative ? -value : value;
    }
  }
}

}  // namespace

Traction exchanged(Traction traction) {
  if (traction == Traction::pressure) return traction;
  return traction == Traction::shear_x ? Traction::shear_y : Traction::shear_x;
}

Axis exchanged(Axis axis) {
  if (axis == Axis::z) return axis;
  return axis == Axis::x ? Axis::y : Axis::x;
}

Grid exchanged(const Grid& grid) {
  Grid rotated = grid;
  std::swap(rotated.nx, rotated.ny);
  std::swap(rotated.dx, rotated.dy);
  std::swap(rotated.period.x, rotated.period.y);
  return rotated;
}

std::shared_ptr<const PeriodicTable> PeriodicSums::table(const Grid& grid, int cells_x,
                                                         int step) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find_if(tables_, [&](const auto& kept) {
    return kept->fits(grid.dx, grid.dy, grid.period, cells_x, step);
  });
  if (found != tables_.end()) {
    tables_.splice(tables_.begin(), tables_, found);
  } else {
    tables_.push_front(
        std::make_shared<const PeriodicTable>(grid.dx, grid.dy, grid.period, cells_x, step,
                                              tables_.empty() ? nullptr : tables_.front().get()));
    if (tables_.size() > max_tables) tables_.pop_back();
  }
  return tables_.front();
}

std::shared_ptr<const Field> PeriodicSums::sums(const std::shared_ptr<const PeriodicTable>& table,
                                                const CellInfluence& influence, int name) const {
  if (name < 0) return std::make_shared<const Field>(table->sum(influence));
  const std::lock_guard lock(named_mutex_);
  const auto found = std::ranges::find_if(
      named_, [&](const Named& kept) { return kept.name == name && kept.table == table; });
  if (found != named_.end()) return found->sums;
  named_.push_front({name, table, std::make_shared<const Field>(table->sum(influence))});
  if (named_.size() > max_tables) named_.pop_back();
  return named_.front().sums;
}

Field PeriodicSums::sum(const Grid& grid, const CellOffsets& offsets, const Make& make,
                        std::span<const int> order, int name, int step) const {
  const bool direct = PeriodicTable::is_direct(grid);
  const Grid rotated = direct ? grid : exchanged(grid);
  const CellOffsets along = direct ? offsets : CellOffsets{offsets.y, offsets.x};
  const int cells_x = 1 + *std::max_element(along.x.begin(), along.x.end());
  const auto table = this->table(rotated, cells_x, step);
  const CellInfluence influence = make(rotated, !direct);
  const auto sums = this->sums(table, influence, name);
  const std::size_t count = influence.parities.size(), nx = offsets.x.size(), ny = offsets.y.size();
  const std::size_t part = static_cast<std::size_t>(table->columns()) * table->rows();
  Field out(count * nx * ny);
  Field one(nx * ny);
  for (std::size_t c = 0; c < count; ++c) {
    double* to = out.data() + (direct ? c : order[c]) * nx * ny;
    unfold(sums->data() + c * part, table->columns(), rotated.period, along, influence.parities[c],
           direct ? to : one.data());
    if (direct) continue;
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) to[j * nx + i] = one[i * ny + j];
    }
  }
  return out;
}

}  // namespace samcontact::operators
