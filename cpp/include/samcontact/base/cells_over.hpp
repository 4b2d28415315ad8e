// SPDX-License-Identifier: GPL-3.0-or-later
// Number of cells that cover a length, independent of the unit of length.
#pragma once

#include <algorithm>
#include <cmath>

namespace samcontact {

/// Number of cells that cover a length. A length that is a whole number of cells, to rounding,
/// needs no extra cell, so the result does not depend on the unit of length.
inline int cells_over(double length, double cell) {
  return static_cast<int>(std::min(std::ceil(length / cell * (1 - 1e-12)), 1e9));
}

}  // namespace samcontact
