// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/window.hpp"

#include <algorithm>

namespace samcontact::contact {
namespace {

/// A window pays when it has less than this share of the cells: it costs kernels of its own.
constexpr double worthwhile_share = 0.6;
constexpr int smallest_side = 64;

/// Widens a range of cells by a margin to a multiple of 8 within [0, n).
void widen(int n, int& start, int& length) {
  const int margin = 4 + length / 8;
  const int wide = std::min(std::max((length + 2 * margin + 7) / 8 * 8, smallest_side), n);
  start = std::clamp(start - (wide - length) / 2, 0, n - wide);
  length = wide;
}

}  // namespace

Box possible_contact(const Grid& grid, const Field& pressure, const Field& gap) {
  const Box box =
      bounding_box(grid, [&](std::size_t at) { return pressure[at] > 0 || gap[at] < 0; });
  return box.empty() ? Box::surface(grid) : box;
}

Box with_margin(const Grid& grid, const Box& window, const Box& present) {
  Box wide = window;
  widen(grid.nx, wide.i0, wide.nx);
  widen(grid.ny, wide.j0, wide.ny);
  wide = wide.united(present);
  const Box all = Box::surface(grid);
  const double share =
      static_cast<double>(wide.surface_size()) / static_cast<double>(all.surface_size());
  return share < worthwhile_share ? wide : all;
}

}  // namespace samcontact::contact
