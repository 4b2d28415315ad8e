// SPDX-License-Identifier: GPL-3.0-or-later
// The heat that entered the bodies in earlier time steps.
#pragma once

#include <array>
#include <memory>

#include "samcontact/operators/heat/heat_history.hpp"
#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::simulation {

/// How a simulation marches heat in time.
struct HeatMarch {
  /// Shortest time step and longest time that heat is followed [s]; 0: no march.
  double shortest = 0.0, longest = 0.0;
  bool is_on() const { return shortest > 0; }
};

/// By body; null: none. Shared by states, never changed once made.
using PastHeat = std::array<std::shared_ptr<const operators::HeatHistory>, 2>;

}  // namespace samcontact::simulation
