// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/window.hpp"

#include <algorithm>

namespace samcontact::contact {
namespace {

/// A window pays when it has less than this share of the cells: it costs kernels of its own.
constexpr double worthwhile_share = 0.8;
constexpr int smallest_side = 64;
/// Margins in shares of the window: ample, and where that does not pay slim ones.
constexpr int ample = 8, slim = 64;

/// Widens a range of cells by a margin to a multiple of 8 within [0, n).
void widen(int n, int share, int& start, int& length) {
  const int margin = 4 + length / share;
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
  const Box all = Box::surface(grid);
  for (const int margin : {ample, slim}) {
    Box wide = window;
    widen(grid.nx, margin, wide.i0, wide.nx);
    widen(grid.ny, margin, wide.j0, wide.ny);
    wide = wide.united(present);
    if (static_cast<double>(wide.surface_size()) <
        worthwhile_share * static_cast<double>(all.surface_size())) {
      return wide;
    }
  }
  return all;
}

}  // namespace samcontact::contact
