// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets from a cell at which tables of influence coefficients are evaluated.
#pragma once

#include <vector>

namespace samcontact::operators {

/// Offsets of a table, not negative, ascending [m].
struct Offsets {
  std::vector<double> x, y;
  static Offsets lattice(double dx, double dy, int nx, int ny);
};

/// Offsets of a table in cells of the grid, not negative, in any order; they may skip cells.
struct CellOffsets {
  std::vector<int> x, y;

  static CellOffsets lattice(int nx, int ny);
  Offsets in_metres(double dx, double dy) const;
};

}  // namespace samcontact::operators
