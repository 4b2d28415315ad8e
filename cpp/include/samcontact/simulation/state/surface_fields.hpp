// SPDX-License-Identifier: GPL-3.0-or-later
// Gap and displacement of the surfaces of a state.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Separation of the surfaces under load [i][j] [m]; under prescribed tractions for approach 0.
Field gap(const State& state);
/// Displacement of a body's surface along an axis due to its plastic strain, [i][j] of the grid
/// [m].
Field residual_displacement(const State& state, int body, operators::Axis axis);
/// The same over cells of the body, which may lie beside the grid.
Field residual_displacement(const State& state, int body, operators::Axis axis, const Box& region);
/// Displacement u_z of a body's surface, into the body, due to all [i][j] [m].
Field surface_displacement(const State& state, int body);

}  // namespace samcontact::simulation
