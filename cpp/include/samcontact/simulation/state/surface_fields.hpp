// SPDX-License-Identifier: GPL-3.0-or-later
// Gap and surface displacements of a state.
#pragma once

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Separation of the surfaces under load [i][j] [m]; under prescribed tractions for zero approach.
Field gap(const State& state);
/// Surface displacement of a body along an axis due to its plastic strain and eigenstrain, [i][j]
/// of the grid [m].
Field residual_displacement(const State& state, int body, operators::Axis axis);
/// Residual displacement over cells of the body, which may lie outside the grid.
Field residual_displacement(const State& state, int body, operators::Axis axis, const Box& region);
/// Total surface displacement u_z of a body, positive into the body [i][j] [m].
Field surface_displacement(const State& state, int body);

}  // namespace samcontact::simulation
