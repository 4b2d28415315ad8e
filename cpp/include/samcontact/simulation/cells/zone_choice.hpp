// SPDX-License-Identifier: GPL-3.0-or-later
// Which small boxes hold the plastic strain of a body where it lies in many places.
#pragma once

#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::simulation {

/// How deep something is needed below each column of a part of the lattice.
struct Columns {
  Box window;              // its layers do not matter
  std::vector<int> depth;  // [i][j], in layers; 0: not at all
};

/// Boxes around the groups of neighbouring columns, a few cells wider and deeper.
std::vector<Box> boxes_around(const Columns& columns);

/// A box that is some cells wider on all sides, and deeper.
Box widened(const Box& box, int cells);

/// Boxes of a surface that repeats itself along x and y, or not at all: what lies beyond its ends
/// is cut off and moved to where it is within.
std::vector<Box> within_period(const std::vector<Box>& boxes, const Period& period);

/// Disjoint boxes that hold all of these: two become one where that costs less; of two that meet,
/// else one gives way. split: of rings of cells that are swept with zones.
std::vector<Box> merged(const std::vector<Box>& boxes, const operators::BandSplit& split);

/// Work of an evaluation in such zones and in one box, both in cells of transforms and sweeps,
/// which only where the surface ends are padded: `joined` says that it repeats itself. surface:
/// where displacement is known.
double cost_of_zones(const std::vector<Box>& zones, const Box& surface,
                     const operators::BandSplit& split, bool joined);
double cost_of_box(const Box& box, bool joined);

}  // namespace samcontact::simulation
