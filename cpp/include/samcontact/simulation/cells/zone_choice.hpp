// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of small boxes for the plastic strain of a body that lies in many places.
#pragma once

#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::simulation {

/// Required depth below each column of a part of the lattice.
struct Columns {
  Box window;              // only its surface cells matter
  std::vector<int> depth;  // [i][j], in layers; 0: none
};

/// Boxes around groups of neighbouring columns, a few cells wider and deeper.
std::vector<Box> boxes_around(const Columns& columns);

/// Box that is wider by some cells on all sides, and deeper.
Box widened(const Box& box, int cells);

/// Boxes on a surface that is periodic along x and y, or not periodic: parts beyond the ends of the
/// period are cut off and moved into it.
std::vector<Box> within_period(const std::vector<Box>& boxes, const Period& period);

/// Disjoint boxes that contain all given boxes: two boxes are merged if that costs less; of two
/// overlapping boxes one is cut otherwise. split: width of the margins that are evaluated with the
/// zones.
std::vector<Box> merged(const std::vector<Box>& boxes, const operators::BandSplit& split);

/// Work of an evaluation with these zones and with one box, both in cells of transforms and sweeps;
/// surface: cells with known displacement. periodic: whether the surface is periodic and needs no
/// padding.
double cost_of_zones(const std::vector<Box>& zones, const Box& surface,
                     const operators::BandSplit& split, bool periodic);
double cost_of_box(const Box& box, bool periodic);

}  // namespace samcontact::simulation
