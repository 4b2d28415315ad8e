// SPDX-License-Identifier: GPL-3.0-or-later
// How many cells hold a length, whatever it is measured in.
#pragma once

#include <algorithm>
#include <cmath>

namespace samcontact {

/// Cells that hold a length. Where it is a whole number of them rounding adds none, so that other
/// units have as many.
inline int cells_over(double length, double cell) {
  return static_cast<int>(std::min(std::ceil(length / cell * (1 - 1e-12)), 1e9));
}

}  // namespace samcontact
