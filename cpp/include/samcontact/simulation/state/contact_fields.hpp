// SPDX-License-Identifier: GPL-3.0-or-later
// Repulsion of the bodies in a state, and the energy of their attraction, by its contact law.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Pressure without the attraction of the bodies [i][j] [Pa]: cells with a repulsion are in
/// contact. That of a prescribed pressure without attraction is the pressure.
Field repulsion(const State& state);
/// Work done against the attraction to open the gap [J].
double attraction_energy(const State& state);

}  // namespace samcontact::simulation
