// SPDX-License-Identifier: GPL-3.0-or-later
// Repulsion of the surfaces in a state, and energy of their attraction, by the contact law.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Pressure without the attraction of the surfaces [i][j] [Pa]: cells with a repulsion are in
/// contact. A prescribed pressure has no attraction and is the repulsion.
Field repulsion(const State& state);
/// Work against the attraction when the gap opened [J].
double attraction_energy(const State& state);

}  // namespace samcontact::simulation
