// SPDX-License-Identifier: GPL-3.0-or-later
// How large the box of a body is that holds its plastic strain: what must be in it, with room to
// grow.
#pragma once

#include "samcontact/base/box.hpp"
#include "samcontact/simulation/cells/mirror.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {

/// Whole boxes, but for those that are called stored: the part from the mirror planes on. A box may
/// reach beyond the grid, below and beside it, but for directions in which it is periodic.
class BoxChoice {
 public:
  BoxChoice(const Grid& grid, fft::Symmetry symmetry) : grid_(grid), symmetry_(symmetry) {}

  /// Cells around what must be in a box: those of the grid, and beyond where it ends at the border.
  Box with_margin(const Box& box) const;
  /// A stored box for what is needed, instead of the stored box `before`, which may be empty.
  Box fitted(const Box& needed, const Box& before) const;
  /// What a stored box must hold besides itself where some cells of its rim flow; stored.
  Box rim_of(const Box& box, const Cell& cell) const;
  /// What of it lies in the grid or in a stored box.
  Box in_grid_or(const Box& box, const Box& needed) const;
  /// Part from the mirror planes on of a box that was widened.
  Box stored(Box box) const;

  Box whole(const Box& stored) const { return whole_box(stored, grid_, symmetry_); }
  bool mirrors_x() const { return symmetry_ == fft::Symmetry::xy; }
  bool mirrors_y() const { return symmetry_ != fft::Symmetry::none; }

 private:
  const Grid& grid_;
  fft::Symmetry symmetry_;
};

/// Whether a whole box reaches too far from the grid for anything but a half-space that flows as a
/// whole.
bool has_no_end(const Box& box, const Grid& grid);

}  // namespace samcontact::simulation
