// SPDX-License-Identifier: GPL-3.0-or-later
// Rise of temperature of the bodies of a state.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// At mid-depth of the layers [k][i][j] [K]. Throws std::invalid_argument for a grid without volume
/// or a rigid body.
Field temperature(const State& state, int body, Layers layers = {});
/// Of the surface [i][j] [K].
Field surface_temperature(const State& state, int body);

}  // namespace samcontact::simulation
