// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that move through the contact along x: the grid stays with the contact.
#pragma once

#include <array>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"

namespace samcontact::simulation {

/// How far each body's surface has moved through the contact [cells], towards +x.
using Travel = std::array<double, 2>;

/// Sum of both; what is a whole number but for rounding is made one.
Travel advanced(const Travel& travel, const Travel& by);

/// Where the cells of the grid lie on the bodies. A body that remembers has cells of its own; the
/// grid's are those of the body it follows, so that a part of a cell moves the contact's origin
/// within the grid.
struct Placement {
  /// The body's cell that takes the place of the grid's first one.
  std::array<int, 2> first{};
  /// How far it lies from there, towards -x, in [-0.5, 0.5] cells; 0 for the body that is followed.
  std::array<double, 2> offset{};
  /// How far the contact's origin is from the middle of the grid, towards +x, in [-0.5, 0.5] cells.
  double origin = 0.0;

  /// followed: index of the body, or -1 when none remembers.
  Placement(const Travel& travel, int followed);
};

/// Heights of a body's surface [m], positive out of the body, that move with it.
struct Relief {
  Field heights;  // [i][j], rows of the grid's ny; empty: none
  int rows = 0;
  int first = 0;          // the grid's row that the first of them starts from
  bool periodic = false;  // along x; otherwise flat beyond
  /// How much material has been worn off [m], as the heights: what is told of depths in the body is
  /// counted from the surface before. Empty: none.
  Field worn = {};

  /// Height at a row of the body, counted from the grid's first at the start.
  double at(int row, int j, int ny) const { return at(heights, row, j, ny); }
  /// What has been worn off there; beside the rows of the grid's cells along y as at the nearest.
  double worn_at(int row, int j, int ny) const;

 private:
  double at(const Field& field, int row, int j, int ny) const;
};
using Reliefs = std::array<Relief, 2>;

/// What a field is beyond the rows of the grid.
enum class Beyond { zero, as_last };

/// A surface field [i][j] seen from cells that lie `offset` cells towards -x, by mean values over
/// them: the sum of one that is zero beyond the grid stays but for what leaves it.
Field seen_from_body(const Field& field, const Grid& grid, double offset,
                     Beyond beyond = Beyond::zero);
operators::Tractions seen_from_body(const operators::Tractions& tractions, const Grid& grid,
                                    double offset);

/// The gap with its origin moved by `shift` cells towards +x, by cubic interpolation. Infinite
/// where the nearest row has no body; beside such rows, linear between two with a body, or
/// constant.
Field shifted_gap(const Field& gap, const Grid& grid, double shift);

/// A surface field moved by whole cells towards +x; zero comes in.
Field moved(const Field& field, const Grid& grid, int cells);

}  // namespace samcontact::simulation
