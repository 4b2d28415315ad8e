// SPDX-License-Identifier: GPL-3.0-or-later
// Stress in the volume of a state, computed on demand.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

// Fields of a body (0 or 1) at mid-depth of its layers, [component][k][i][j] on the cells of the
// body [Pa], see Placement. They throw std::invalid_argument for a grid without layers or a rigid
// body.

/// Stress due to tractions, plastic strain and sources.
Field stress(const State& state, int body, Layers layers = {});
/// Part of the stress that remains after unloading.
Field residual_stress(const State& state, int body, Layers layers = {});
/// Residual stress over cells of the body inside or outside the grid.
Field residual_stress(const State& state, int body, const Box& region);
/// Stress due to plastic strain and to the mismatch of inclusions alone.
Field disturbance(const State& state, int body, Layers layers = {});
/// Initial stress.
Field initial_stress(const State& state, int body, Layers layers = {});
Field initial_stress(const State& state, int body, const Box& region);

/// Stress due to the prescribed eigenstrain.
Field eigenstress(const State& state, int body, Layers layers = {});
Field eigenstress(const State& state, int body, const Box& region);

/// Stress in the zones of a body, with or without the stress due to tractions,
/// [zone][component][k][i][j].
Field stress_in_zones(const State& state, int body, bool with_tractions);

/// Box in which the plastic strain was last solved for, down to the layers of the grid, if this is
/// a single box that contains all tractions; otherwise empty.
Box own_box(const State& state, int body);
/// Deviator of the stress in this box, with or without the stress due to tractions,
/// [component][k][i][j], by the operators of the increment.
Field deviator_in_own_box(const State& state, int body, bool with_tractions);

}  // namespace samcontact::simulation
