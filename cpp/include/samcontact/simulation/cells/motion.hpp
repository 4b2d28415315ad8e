// SPDX-License-Identifier: GPL-3.0-or-later
// Motion of the bodies through the contact; the grid stays with the contact. Along a periodic
// direction, rows that leave the grid enter it at its other end. Bodies with a history move along y
// by whole cells.
#pragma once

#include <array>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"

namespace samcontact::simulation {

/// Travel of the surface of each body through the contact [cells], positive towards +x and +y.
struct Travel {
  std::array<double, 2> x{}, y{};

  bool moves(int body) const { return x[body] != 0 || y[body] != 0; }
  bool is_along_x() const { return y == std::array<double, 2>{}; }
  bool operator==(const Travel&) const = default;
};

/// Part of a travel.
Travel scaled(const Travel& travel, double by);
/// Sum of two travels; values that are whole numbers except for rounding errors are rounded.
Travel advanced(const Travel& travel, const Travel& by);

/// Position of the grid cells on the bodies. A body with a history has cells of its own. The grid
/// cells coincide with those of the body that is followed, so that a fraction of a cell moves the
/// origin of the contact within the grid.
struct Placement {
  /// Cell of the body at the position of the first grid cell, along x and y.
  std::array<int, 2> first{}, first_y{};
  /// Offset of that cell from the grid cell, towards -x, in [-0.5, 0.5] cells; 0 for the body that
  /// is followed.
  std::array<double, 2> offset{};
  /// Position of the contact origin relative to the grid centre, towards +x, in [-0.5, 0.5] cells.
  double origin = 0.0;

  /// followed: index of the body, or -1 if no body has a history.
  Placement(const Travel& travel, int followed);
};

/// Heights of the surface of a body [m], positive out of the body, which move with it.
struct Relief {
  Field heights;  // [i][j], rows of the grid's ny; empty: none
  int rows = 0;
  int first = 0;          // row of the grid at which the first row of heights starts
  bool periodic = false;  // along x; otherwise flat beyond its ends
  /// Worn depth [m], on the cells of the heights; depths in the body are counted from the original
  /// surface. Empty: no wear.
  Field worn = {};

  /// Height at a row of the body, counted from the initial first row of the grid.
  double at(int row, int j, int ny) const { return at(heights, row, j, ny); }
  /// Worn depth at a row of the body; cells beyond the grid along y take the value of the nearest
  /// cell.
  double worn_at(int row, int j, int ny) const;

 private:
  double at(const Field& field, int row, int j, int ny) const;
};
using Reliefs = std::array<Relief, 2>;

/// Rows beyond each end of the grid that are needed on a body with an offset.
int rows_beyond(const Grid& grid, double offset);

/// Values of a field beyond the rows of a grid that is not periodic along x.
enum class Beyond { zero, as_last };

/// Surface field [i][j] on cells that lie `offset` cells towards -x, as means over them: the sum of
/// a field that is zero beyond the grid is preserved except for the part that leaves the grid.
Field seen_from_body(const Field& field, const Grid& grid, double offset,
                     Beyond beyond = Beyond::zero);
operators::Tractions seen_from_body(const operators::Tractions& tractions, const Grid& grid,
                                    double offset);

/// Gap with its origin moved by `shift` cells towards +x, by cubic interpolation. Infinite if the
/// nearest row has no body; next to such rows, linear between two rows with a body, or constant.
Field shifted_gap(const Field& gap, const Grid& grid, double shift);

/// Whole cells towards +x and +y.
struct Cells {
  int x = 0, y = 0;
};

/// Surface field moved by whole cells; zero enters unless the grid is periodic.
Field moved(const Field& field, const Grid& grid, Cells by);

}  // namespace samcontact::simulation
