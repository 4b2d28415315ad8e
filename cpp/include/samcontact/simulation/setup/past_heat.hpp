// SPDX-License-Identifier: GPL-3.0-or-later
// Heat that entered the bodies in earlier time steps (transient heating with load history).
#pragma once

#include <array>
#include <memory>

#include "samcontact/operators/heat/heat_history.hpp"
#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::simulation {

/// Settings of transient heating with load history.
struct TransientHeating {
  /// Shortest time step, and time for which heat is taken into account [s]; 0: no transient
  /// heating.
  double shortest = 0.0, longest = 0.0;
  /// Longest distances along x and y between two positions of a body [m] if the heat follows the
  /// travel of the bodies; 0: the bodies have constant speeds.
  operators::PlaneVector track{};
  bool is_on() const { return shortest > 0; }
  bool follows() const { return track != operators::PlaneVector{}; }
};

/// Heat histories by body; null: no history. Shared by states, immutable.
using PastHeat = std::array<std::shared_ptr<const operators::HeatHistory>, 2>;

}  // namespace samcontact::simulation
