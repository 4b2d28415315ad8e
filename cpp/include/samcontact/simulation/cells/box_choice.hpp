// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the box for the plastic strain of a body: the required cells with a margin for growth.
#pragma once

#include "samcontact/base/box.hpp"
#include "samcontact/simulation/cells/mirror.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {

/// All boxes are whole boxes, except boxes called stored: these are the part on one side of the
/// mirror planes. A box may extend beyond the grid, laterally and below, except along periodic
/// directions.
class BoxChoice {
 public:
  BoxChoice(const Grid& grid, fft::Symmetry symmetry) : grid_(grid), symmetry_(symmetry) {}

  /// Box with a margin: within the grid, and beyond its edges if the box reaches them.
  Box with_margin(const Box& box) const;
  /// Stored box for the required cells, which replaces the stored box `before`, which may be empty.
  Box fitted(const Box& needed, const Box& before) const;
  /// Stored box of additional cells that a stored box must contain because of plastic flow in a
  /// cell of its outermost layer.
  Box rim_of(const Box& box, const Cell& cell) const;
  /// Part of the box that lies in the grid or in a stored box.
  Box in_grid_or(const Box& box, const Box& needed) const;
  /// Stored part of a widened box.
  Box stored(Box box) const;

  Box whole(const Box& stored) const { return whole_box(stored, grid_, symmetry_); }
  bool mirrors_x() const { return symmetry_ == fft::Symmetry::xy; }
  bool mirrors_y() const { return symmetry_ != fft::Symmetry::none; }

 private:
  const Grid& grid_;
  fft::Symmetry symmetry_;
};

/// Whether a whole box extends so far from the grid that only an unbounded plastic zone explains
/// it.
bool is_unbounded(const Box& box, const Grid& grid);

}  // namespace samcontact::simulation
