// SPDX-License-Identifier: GPL-3.0-or-later
// The step by which windows and bands go over into each other.
#pragma once

#include <algorithm>

namespace samcontact {

/// From 0 at 0 to 1 at 1, constant beyond, with three continuous derivatives; with its mirror image
/// 1.
inline double rising(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * t * (35 + t * (-84 + t * (70 - 20 * t)));
}

}  // namespace samcontact
