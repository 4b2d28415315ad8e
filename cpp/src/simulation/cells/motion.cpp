// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/motion.hpp"

#include <algorithm>
#include <cmath>

namespace samcontact::simulation {
namespace {

/// Smaller fractions of a cell are rounding.
constexpr double rounding = 1e-6;

double snapped(double cells) {
  const double whole = std::round(cells);
  return std::fabs(cells - whole) < rounding ? whole : cells;
}

/// Row or column of the grid at an index that may lie in another period.
int within(int index, int cells, double period) {
  return period > 0 ? (index % cells + cells) % cells : index;
}
int row_of(const Grid& grid, int i) { return within(i, grid.nx, grid.period.x); }

}  // namespace

Travel scaled(const Travel& travel, double by) {
  return {{by * travel.x[0], by * travel.x[1]}, {by * travel.y[0], by * travel.y[1]}};
}

Travel advanced(const Travel& travel, const Travel& by) {
  return {{snapped(travel.x[0] + by.x[0]), snapped(travel.x[1] + by.x[1])},
          {snapped(travel.y[0] + by.y[0]), snapped(travel.y[1] + by.y[1])}};
}

Placement::Placement(const Travel& travel, int followed) {
  for (int b = 0; b < 2; ++b) first_y[b] = static_cast<int>(std::lround(-travel.y[b]));
  if (followed < 0) {
    for (int b = 0; b < 2; ++b) first[b] = static_cast<int>(std::lround(-travel.x[b]));
    return;
  }
  first[followed] = static_cast<int>(std::lround(-travel.x[followed]));
  origin = -travel.x[followed] - first[followed];
  const int other = 1 - followed;
  const double place = snapped(-travel.x[other] - origin);
  first[other] = static_cast<int>(std::lround(place));
  offset[other] = place - first[other];
}

double Relief::worn_at(int row, int j, int ny) const {
  return at(worn, row, std::clamp(j, 0, ny - 1), ny);
}

double Relief::at(const Field& field, int row, int j, int ny) const {
  if (field.empty()) return 0.0;
  int r = row - first;
  if (periodic) r = (r % rows + rows) % rows;
  if (r < 0 || r >= rows) return 0.0;
  return field[static_cast<std::size_t>(r) * ny + j];
}

int rows_beyond(const Grid& grid, double offset) {
  return offset == 0 || grid.period.x > 0 ? 0 : 1;
}

Field seen_from_body(const Field& field, const Grid& grid, double offset, Beyond beyond) {
  if (offset == 0 || field.empty()) return field;
  // Cell i of the body covers parts of the grid cells i and i + side.
  const int side = offset > 0 ? -1 : 1;
  const double part = std::fabs(offset);
  Field out(field.size());
  for (int i = 0; i < grid.nx; ++i) {
    const int next = row_of(grid, i + side);
    const bool inside = next >= 0 && next < grid.nx;
    const double* own = field.data() + static_cast<std::size_t>(i) * grid.ny;
    const int to_neighbour = inside ? (next - i) * grid.ny : 0;
    const double share = inside || beyond == Beyond::as_last ? part : 0.0;
    double* to = out.data() + static_cast<std::size_t>(i) * grid.ny;
    for (int j = 0; j < grid.ny; ++j) to[j] = (1 - part) * own[j] + share * own[j + to_neighbour];
  }
  return out;
}

operators::Tractions seen_from_body(const operators::Tractions& tractions, const Grid& grid,
                                    double offset) {
  return {seen_from_body(tractions.pressure, grid, offset),
          seen_from_body(tractions.shear_x, grid, offset),
          seen_from_body(tractions.shear_y, grid, offset)};
}

namespace {

/// Gap at row x of a column in which the bodies end.
double next_to_end(const Field& gap, const Grid& grid, double x, int j) {
  const auto at = [&](int row) {
    return gap[static_cast<std::size_t>(row_of(grid, row)) * grid.ny + j];
  };
  const bool repeats = grid.period.x > 0;
  const double inside = repeats ? x : std::clamp(x, 0.0, grid.nx - 1.0);
  const double nearest = at(static_cast<int>(std::lround(inside)));
  const int before = static_cast<int>(std::floor(inside)),
            after = repeats ? before + 1 : std::min(before + 1, grid.nx - 1);
  if (!std::isfinite(nearest) || !std::isfinite(at(before)) || !std::isfinite(at(after))) {
    return nearest;
  }
  return at(before) + (inside - before) * (at(after) - at(before));
}

}  // namespace

Field shifted_gap(const Field& gap, const Grid& grid, double shift) {
  if (shift == 0) return gap;
  Field out(gap.size());
  // Lagrange polynomials through up to four rows; they extrapolate at the ends.
  const int points = std::min(4, grid.nx);
  for (int i = 0; i < grid.nx; ++i) {
    const double x = i - shift;
    const int around = static_cast<int>(std::floor(x)) - (points - 1) / 2;
    const int first = grid.period.x > 0 ? around : std::clamp(around, 0, grid.nx - points);
    double* to = out.data() + static_cast<std::size_t>(i) * grid.ny;
    std::fill_n(to, grid.ny, 0.0);
    for (int n = 0; n < points; ++n) {
      double weight = 1.0;
      for (int m = 0; m < points; ++m) {
        if (m != n) weight *= (x - (first + m)) / (n - m);
      }
      const double* from = gap.data() + static_cast<std::size_t>(row_of(grid, first + n)) * grid.ny;
      for (int j = 0; j < grid.ny; ++j) to[j] += weight * from[j];
    }
    // A row without a body yields infinities of both signs, or NaN.
    for (int j = 0; j < grid.ny; ++j) {
      if (!std::isfinite(to[j])) to[j] = next_to_end(gap, grid, x, j);
    }
  }
  return out;
}

Field moved(const Field& field, const Grid& grid, Cells by) {
  if ((by.x == 0 && by.y == 0) || field.empty()) return field;
  Field out(field.size(), 0.0);
  for (int i = 0; i < grid.nx; ++i) {
    const int row = row_of(grid, i - by.x);
    if (row < 0 || row >= grid.nx) continue;
    const double* from = field.data() + static_cast<std::size_t>(row) * grid.ny;
    double* to = out.data() + static_cast<std::size_t>(i) * grid.ny;
    for (int j = 0; j < grid.ny; ++j) {
      const int column = within(j - by.y, grid.ny, grid.period.y);
      if (column >= 0 && column < grid.ny) to[j] = from[column];
    }
  }
  return out;
}

}  // namespace samcontact::simulation
