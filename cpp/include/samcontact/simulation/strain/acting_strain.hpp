// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic strain of a body that acts on a region, and its stress and displacement there.
#pragma once

#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// Box of the region and of the strain that acts on it, at most `reach` cells beyond it along x.
/// Its size takes few values, so that operators can be reused.
Box acting_box(const PlasticState& history, const Box& receiving, int reach);
/// Zones, and the strain outside them that acts on the grid, at most `reach` cells beyond it along
/// x. tables: of the body. Without mirror planes.
Zones acting_zones(const PlasticState& history, const Zones& zones,
                   const operators::ZoneTables& tables, int reach);

/// Stress due to all strain that acts on a region, [component][k][i][j] of all six components [Pa].
Field stress_of(const PlasticState& history, const Setup& setup, int body,
                operators::ResidualMethod method, const Box& region);

/// Surface displacement along an axis due to that strain, [i][j] of a region [m].
Field displacement_of(const PlasticState& history, const Setup& setup, int body,
                      operators::ResidualMethod method, operators::Axis axis, const Box& region);
/// Surface displacement on the cells of the grid, from which the cells of the body are offset, see
/// Placement.
Field displacement_of(const PlasticState& history, const Setup& setup, int body,
                      operators::ResidualMethod method, operators::Axis axis, double offset);

}  // namespace samcontact::simulation
