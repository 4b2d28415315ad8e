// SPDX-License-Identifier: GPL-3.0-or-later
// Data for a change of the working set, from two sweeps over all cells: on large grids a sweep
// takes the time to read the fields from memory.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Totals of pressure p, gap h and rest = h + u. Sums do not depend on the number of threads.
struct Totals {
  double contacts = 0.0;          // cells with p > 0
  double rest_in_contact = 0.0;   // sum of rest where p > 0
  double pressure = 0.0;          // sum of p
  double energy = 0.0;            // sum of p (rest + h)/2
  double largest_pressure = 0.0;  // at least 0
  double largest_displacement = 0.0;
};
Totals totals(const Field& pressure, const Field& rest, const Field& gap);

/// State of a cell, from which the cells of a working set are chosen.
enum CellState : unsigned char { idle, working, penetrating };

struct Survey {
  double error = 0.0;           // error of a Solution
  std::size_t working = 0;      // cells with p above `hold` times the gap
  std::size_t dropped = 0;      // cells with p > 0, but not above
  std::size_t penetrating = 0;  // cells with p <= 0 and rest below the approach
};
/// Determines the state of each cell.
Survey survey(const Field& pressure, const Field& rest, double approach, double hold,
              const Totals& scales, std::vector<unsigned char>& states);

}  // namespace samcontact::contact
