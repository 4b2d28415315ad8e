// SPDX-License-Identifier: GPL-3.0-or-later
// The strain of a body that acts on some of its cells, and what it does there.
#pragma once

#include "samcontact/simulation/scene/scene.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// A box and the strain that acts on it, at most `reach` cells beyond it along x. The size takes
/// few values, so that operators on it can be kept.
Box acting_box(const PlasticState& history, const Box& wanted, int reach);
/// Zones and the strain outside of them that acts on the grid, at most `reach` cells beyond it
/// along x. tables: of the body. Without mirror planes.
Zones acting_zones(const PlasticState& history, const Zones& zones,
                   const operators::ZoneTables& tables, int reach);

/// Stress of all strain that acts on a region, [component][k][i][j] of all six components.
Field stress_of(const PlasticState& history, const Scene& scene, int body,
                operators::ResidualMethod method, const Box& region);

/// Displacement of the surface along an axis due to it, [i][j] of a region.
Field displacement_of(const PlasticState& history, const Scene& scene, int body,
                      operators::ResidualMethod method, operators::Axis axis, const Box& region);
/// The same of the grid's cells, where the body's cells lie at an offset from them, see Placement.
Field displacement_of(const PlasticState& history, const Scene& scene, int body,
                      operators::ResidualMethod method, operators::Axis axis, double offset);

}  // namespace samcontact::simulation
