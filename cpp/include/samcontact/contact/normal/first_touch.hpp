// SPDX-License-Identifier: GPL-3.0-or-later
// Cells that touch for the first time within an increment: what they slip in touch.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::contact {

/// Sliding under a wave of shear across its direction over that along it: 1/(1 - nu).
double crosswise_compliance(const Grid& grid, const operators::TangentialInfluence& influence);

/// Increment of a contact that grows.
struct Growth {
  const Field& before;    // pressure [i][j]
  const Field& pressure;  // at its end
  const Field& gap;       // before [m]
  double closer;          // by which the bodies approach [m], > 0
  /// The rigid motion where it is given, and what it is at most for its shear [m].
  double slid, most_slid;
};

/// Symmetric matrices [xx, xy, yy][i][j]: what cells slip of a rigid motion while they touch, as if
/// displaced over the whole increment. Rigid bodies that approach steadily close a gap after its
/// share of the increment; elastic displacement changes what they close and what they slip before
/// in one proportion across the edge of the contact and in another along it, those of a round
/// contact as it grows. Motions beyond what shear displaces do not change that. Empty where nothing
/// touches for the first time.
Field slip_in_touch(const Grid& grid, const Growth& growth, double crosswise);

}  // namespace samcontact::contact
