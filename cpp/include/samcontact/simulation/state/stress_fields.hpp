// SPDX-License-Identifier: GPL-3.0-or-later
// Stress in the volume of a state, computed when it is asked for.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

// Fields of a body (0 or 1) at mid-depth of its layers, [component][k][i][j] in the body's cells,
// see Placement. They throw std::invalid_argument for a grid without volume or a rigid body.

/// Of tractions, plastic strain and sources.
Field stress(const State& state, int body, Layers layers = {});
/// What remains of it when the bodies are unloaded.
Field residual_stress(const State& state, int body, Layers layers = {});
/// Over cells of the body beside or in the grid.
Field residual_stress(const State& state, int body, const Box& region);
/// The stress that is there from the start.
Field initial_stress(const State& state, int body, Layers layers = {});
Field initial_stress(const State& state, int body, const Box& region);

/// The stress of the eigenstrain that is given.
Field eigenstress(const State& state, int body, Layers layers = {});
Field eigenstress(const State& state, int body, const Box& region);

/// Stress in the zones of a body, all of it or what remains, [zone][component][k][i][j].
Field stress_in_zones(const State& state, int body, bool with_tractions);

/// The box that the plastic strain was last solved for in, down to the layers of the grid, where
/// it is one and holds all tractions; else empty.
Box own_box(const State& state, int body);
/// Deviator of the stress in it, all of it or what remains, [component][k][i][j], by the operators
/// of the increment.
Field deviator_in_own_box(const State& state, int body, bool with_tractions);

}  // namespace samcontact::simulation
