// SPDX-License-Identifier: GPL-3.0-or-later
// Outline of a contact, and steps of the gap, on the cells of a grid: quantities that diagnostics
// need for every solution.
#pragma once

#include <cstddef>
#include <span>

namespace samcontact::contact {

/// Numbers of surface cells along x and y, and the axes along which they are periodic.
struct Cells {
  int nx = 0, ny = 0;
  bool along_x = false, along_y = false;
};

struct Outline {
  std::size_t cells = 0;  // in contact
  std::size_t sides = 0;  // sides of these cells shared with cells out of contact; the edge of the
                          // grid does not count
  int reach = 0;       // smallest number of cells between the maximum pressure and the edge of the
                       // contact, along x and y, within the grid
  bool rises = false;  // whether the pressure of a cell at the edge of the contact exceeds `rise`
                       // times that of the next cell inside
  double largest = 0.0;  // pressure [Pa]
};

/// Outline of a pressure [i][j] >= 0 [Pa]. rise: ratio above which the pressure counts as rising
/// towards the edge.
Outline outline(std::span<const double> pressure, const Cells& cells, double rise);

/// Whether heights [i][j] may have a step between the third and the fourth of any six consecutive
/// cells along x or y: the height of the step exceeds the change of slope across it, and `ratio`
/// times the changes of slope next to it. Always true if a height is infinite.
bool may_have_steps(std::span<const double> heights, const Cells& cells, double ratio);

}  // namespace samcontact::contact
