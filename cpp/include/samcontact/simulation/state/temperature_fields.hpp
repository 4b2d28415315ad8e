// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature rise of the bodies of a state.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Temperature rise at mid-depth of the layers [k][i][j] [K]. Throws std::invalid_argument for a
/// grid without layers or a rigid body.
Field temperature(const State& state, int body, Layers layers = {});
/// Temperature rise of the surface [i][j] [K].
Field surface_temperature(const State& state, int body);

}  // namespace samcontact::simulation
