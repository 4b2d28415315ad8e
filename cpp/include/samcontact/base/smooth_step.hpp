// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth step for transitions between windows and between bands.
#pragma once

#include <algorithm>

namespace samcontact {

/// Smooth step from 0 at 0 to 1 at 1, constant outside this interval, with three continuous
/// derivatives. The step and its mirror image add up to 1.
inline double rising(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * t * (35 + t * (-84 + t * (70 - 20 * t)));
}

}  // namespace samcontact
