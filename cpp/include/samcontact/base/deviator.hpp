// SPDX-License-Identifier: GPL-3.0-or-later
// Invariants of deviatoric tensors.
#pragma once

namespace samcontact {

/// Half the squared norm of a deviator: a third of the square of its von Mises stress.
inline double second_invariant(double xx, double yy, double yz, double xz, double xy) {
  return xx * xx + yy * yy + xx * yy + yz * yz + xz * xz + xy * xy;
}

}  // namespace samcontact
