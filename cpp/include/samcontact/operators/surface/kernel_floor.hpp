// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bound of the eigenvalues of displacement kernels in preconditioners.
#pragma once

#include <cmath>
#include <numbers>

#include "samcontact/base/grid.hpp"

namespace samcontact::operators {

/// Lower bound to which the eigenvalues of a kernel truncated by its period are raised, so that the
/// preconditioner is positive definite for any shape of the cells: a tenth of the compliance of the
/// half-spaces at the shortest wave of the grid.
template <class Influence>
double kernel_floor(const Grid& box, const Influence& influence) {
  const double shortest = std::numbers::pi * std::hypot(1 / box.dx, 1 / box.dy);  // [rad/m]
  return 0.1 * influence.wave_compliance(shortest);
}

}  // namespace samcontact::operators
