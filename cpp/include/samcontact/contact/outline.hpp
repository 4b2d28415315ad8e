// SPDX-License-Identifier: GPL-3.0-or-later
// Outline of a contact in the cells of its grid: what diagnostics ask of every solution, in a
// sweep.
#pragma once

#include <cstddef>
#include <span>

namespace samcontact::contact {

/// Cells of a surface, and along which axes they are periodic.
struct Cells {
  int nx = 0, ny = 0;
  bool along_x = false, along_y = false;
};

struct Outline {
  std::size_t cells = 0;  // in contact
  std::size_t sides = 0;  // that these share with others; the border of the grid is none
  int reach = 0;  // contact reaches from this many cells before the largest pressure to one less
                  // behind it, along x and y, within the grid
  bool rises = false;    // whether the pressure rises to a side, from the next cell further inside
  double largest = 0.0;  // pressure [Pa]
};

/// Of a pressure [i][j] >= 0 [Pa]. rise: by which factor it rises, at least.
Outline outline(std::span<const double> pressure, const Cells& cells, double rise);

}  // namespace samcontact::contact
