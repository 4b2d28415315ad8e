// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/box_choice.hpp"

#include <algorithm>

#include "samcontact/fft/plan.hpp"

namespace samcontact::simulation {
namespace {

/// Margin around the required cells of a box [cells].
constexpr int box_margin = 2;
/// Maximum size of a box, in grid widths,
constexpr int max_widths = 3;
/// or in cells, for long cells: a single row with its margins is five rows wide.
constexpr int always_allowed = 16;

/// Adds a margin to [begin, end), within [0, n) unless the range reaches its end.
void widen(int n, int& begin, int& end) {
  begin = begin > 0 ? std::max(0, begin - box_margin) : begin - box_margin;
  end = end < n ? std::min(n, end + box_margin) : end + box_margin;
}

/// Extent of a box that contains [begin, end) and had `before` cells: with a margin for growth, and
/// a number of cells with a fast transform. It stays within the n cells of the grid if these
/// contain the required ones. Equal numbers are added at both ends, so that mirror-symmetric
/// contacts have mirror-symmetric boxes.
void fit_extent(int n, int before, bool mirrored, int& begin, int& end) {
  if (mirrored) {
    begin = std::min(begin, n - end);
    end = n - begin;
  }
  const int needed = end - begin;
  int cells = needed;
  if (before > 0 && cells > before) cells = std::max(cells, before + before / 4);
  const auto good = [](int count) { return (fft::good_even_size(2 * count - 1) + 1) / 2; };
  for (cells = good(cells); (cells - needed) % 2 != 0;) cells = good(cells + 1);
  const bool inside = begin >= 0 && end <= n;
  if (inside && cells > n - n / 8) cells = n;
  begin -= (cells - needed) / 2;
  if (inside) begin = std::clamp(begin, 0, n - cells);
  end = begin + cells;
}

}  // namespace

Box BoxChoice::with_margin(const Box& box) const {
  int i0 = box.i0, i1 = box.i0 + box.nx, j0 = box.j0, j1 = box.j0 + box.ny;
  widen(grid_.nx, i0, i1);
  widen(grid_.ny, j0, j1);
  if (grid_.period.x > 0) {
    i0 = std::max(i0, 0);
    i1 = std::min(i1, grid_.nx);
  }
  if (grid_.period.y > 0) {
    j0 = std::max(j0, 0);
    j1 = std::min(j1, grid_.ny);
  }
  const int nz = box.nz < grid_.nz ? std::min(grid_.nz, box.nz + box_margin) : box.nz + box_margin;
  return {i0, j0, i1 - i0, j1 - j0, nz, std::max(0, box.k0 - box_margin)};
}

Box BoxChoice::fitted(const Box& needed, const Box& before) const {
  const Box old = before.empty() ? Box{} : whole(before);
  int i0 = needed.i0, i1 = needed.i0 + needed.nx, j0 = needed.j0, j1 = needed.j0 + needed.ny;
  // The box is periodic if the surface is.
  if (grid_.period.x > 0) {
    i0 = 0;
    i1 = grid_.nx;
  } else {
    fit_extent(grid_.nx, old.nx, mirrors_x(), i0, i1);
  }
  if (grid_.period.y > 0) {
    j0 = 0;
    j1 = grid_.ny;
  } else {
    fit_extent(grid_.ny, old.ny, mirrors_y(), j0, j1);
  }
  int nz = needed.nz;
  if (before.nz > 0 && nz > before.nz) nz = std::max(nz, before.nz + before.nz / 4);
  if (needed.nz <= grid_.nz && nz > grid_.nz - grid_.nz / 8) nz = grid_.nz;
  return stored({i0, j0, i1 - i0, j1 - j0, nz, needed.k0});
}

Box BoxChoice::rim_of(const Box& box, const Cell& cell) const {
  const int i = cell.i - box.i0, j = cell.j - box.j0;
  const bool rim = (i == 0 && !mirrors_x()) || (j == 0 && !mirrors_y()) || i == box.nx - 1 ||
                   j == box.ny - 1 || cell.k == box.nz - 1 || (cell.k == box.k0 && cell.k > 0);
  return rim ? with_margin({cell.i, cell.j, 1, 1, cell.k + 1, cell.k}) : box;
}

Box BoxChoice::in_grid_or(const Box& box, const Box& needed) const {
  Box allowed = box.united(Box::whole(grid_)).from_surface();
  if (grid_.nz == 0) allowed.nz = std::max(allowed.nz, needed.nz);
  return needed.intersected(allowed);
}

Box BoxChoice::stored(Box box) const {
  const Box part = stored_part(grid_, symmetry_);
  const int i1 = box.i0 + box.nx, j1 = box.j0 + box.ny;
  if (mirrors_x()) box.i0 = std::max(box.i0, part.i0);
  if (mirrors_y()) box.j0 = std::max(box.j0, part.j0);
  box.nx = i1 - box.i0;
  box.ny = j1 - box.j0;
  return box;
}

bool is_unbounded(const Box& box, const Grid& grid) {
  const double width = max_widths * std::max(grid.nx * grid.dx, grid.ny * grid.dy);
  const double depth = std::max(width, 2 * grid.nz * grid.dz);
  const Box all = box.united(Box::surface(grid));
  const auto too_far = [](int cells, double length, double max_length) {
    return cells > always_allowed && cells * length > max_length;
  };
  return too_far(all.nx, grid.dx, width) || too_far(all.ny, grid.dy, width) ||
         too_far(all.nz, grid.dz, depth);
}

}  // namespace samcontact::simulation
