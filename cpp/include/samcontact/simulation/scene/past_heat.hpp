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
  /// Shortest time step, and longest time over which heat is followed [s]; 0: no transient heating.
  double shortest = 0.0, longest = 0.0;
  bool is_on() const { return shortest > 0; }
};

/// Heat histories by body; null: none. Shared by states, immutable.
using PastHeat = std::array<std::shared_ptr<const operators::HeatHistory>, 2>;

}  // namespace samcontact::simulation
