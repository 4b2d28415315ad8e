// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/window.hpp"

#include <algorithm>

#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// A smaller rectangle is used if it has less than this fraction of the cells, because it needs
/// kernels of its own.
constexpr double max_window_fraction = 0.8;
constexpr int smallest_side = 64;
/// Margins as fractions of the rectangle (1/8, 1/64): the smaller one if the larger one saves too
/// little.
constexpr int wide_divisor = 8, narrow_divisor = 64;

/// Widens a range of cells to at least `min_length`, and to a multiple of 8 within [0, n).
void widen(int n, int min_length, int& start, int& length) {
  const int wide = std::min((min_length + 7) / 8 * 8, n);
  start = std::clamp(start - (wide - length) / 2, 0, n - wide);
  length = wide;
}

/// Length of a side with a margin at both ends.
int side_of_window(int length, int divisor) {
  return std::max(length + 2 * (4 + length / divisor), smallest_side);
}

}  // namespace

Box possible_contact(const Grid& grid, const Field& pressure, const Field& gap) {
  const Box box =
      bounding_box(grid, [&](std::size_t at) { return in_contact(pressure[at]) || gap[at] < 0; });
  return box.empty() ? Box::surface(grid) : box;
}

Box with_margin(const Grid& grid, const Box& window, const Box& present) {
  const Box all = Box::surface(grid);
  for (const int divisor : {wide_divisor, narrow_divisor}) {
    Box wide = window;
    widen(grid.nx, side_of_window(wide.nx, divisor), wide.i0, wide.nx);
    widen(grid.ny, side_of_window(wide.ny, divisor), wide.j0, wide.ny);
    wide = wide.united(present);
    if (static_cast<double>(wide.surface_size()) <
        max_window_fraction * static_cast<double>(all.surface_size())) {
      return wide;
    }
  }
  return all;
}

Box slipping_box(const Grid& grid, const Field& pressure, const Field& before) {
  const std::size_t n = before.size() / 2;
  Box box = bounding_box(grid, [&](std::size_t at) {
    return in_contact(pressure[at]) || (n > 0 && (before[at] != 0 || before[n + at] != 0));
  });
  if (box.empty()) return box;
  widen(grid.nx, box.nx, box.i0, box.nx);
  widen(grid.ny, box.ny, box.j0, box.ny);
  return box;
}

}  // namespace samcontact::contact
