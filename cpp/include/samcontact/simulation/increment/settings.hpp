// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances and methods of a simulation.
#pragma once

#include <array>
#include <functional>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::simulation {

/// Factor on the yield stress of a body as a function of the temperature rise [K], both [k][i][j]
/// of a box.
using Softening = std::function<Field(const Field& temperature, const Box& box)>;

/// Defaults and ranges are set by the caller.
struct Settings {
  double tol{};  // relative change of the plastic strain increment, and relative violation of the
                 // yield condition
  /// Error of the division into sub-increments, by step doubling; 0: no subdivision.
  double increment_tol{};
  int max_iterations{};
  contact::OnBorder on_border{};
  /// Whether the state with the smallest error is accepted, with a warning, if pressure and shear
  /// do not converge.
  bool accepts_stall = false;
  /// Action in the present attempt.
  contact::AfterStall after_stall = contact::AfterStall::fail;
  operators::ResidualMethod residual_stress{};
  /// Fast residual stress: error due to periodic images, relative to the largest stress.
  double image_tol{};
  /// Distance beyond the grid along x within which plastic strain acts [cells].
  int reach{};
  /// Whether plastic strain is always solved in one box, never in small zones.
  bool one_zone = false;
  /// Band decomposition of the operators of small zones.
  operators::BandSplit split = {};
  int max_halvings = 8;
  /// Softening laws by body; empty: no softening. Called once per increment or sub-increment.
  std::array<Softening, 2> softening = {};
};

}  // namespace samcontact::simulation
