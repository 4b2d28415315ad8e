// SPDX-License-Identifier: GPL-3.0-or-later
// Conditions of an increment on which the bound of a friction law depends, in addition to the
// pressure.
#pragma once

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Cells with less friction, relative to the largest coefficient, have this friction.
inline constexpr double smallest_factor = 1e-9;

/// Surface fields are [i][j] on the grid.
struct FrictionConditions {
  /// Bound of each cell, relative to that of the law, in [0, 1]; empty: 1.
  Field factor = {};
  /// Duration of the increment, or of a unit distance of steady rolling [s, s/m]; 0: unknown, for
  /// laws that do not depend on the slip rate.
  double duration = 0.0;
  /// Slip rate that the friction of each cell has followed so far, at the present positions of its
  /// material points [m/s]; empty: 0.
  Field slip_rate = {};
  /// Plastic slip of the layer between the bodies so far, likewise [m]; empty: 0.
  Field plastic_slip = {};
  /// Whether slip_rate selects one of several possible solutions; otherwise an increment that may
  /// have several is refused.
  bool selects = false;
};

}  // namespace samcontact::contact
