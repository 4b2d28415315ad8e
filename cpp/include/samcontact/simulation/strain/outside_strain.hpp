// SPDX-License-Identifier: GPL-3.0-or-later
// The plastic strain that a moving contact leaves beside it: what it still does.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/simulation/scene/scene.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// What the strain outside of zones does in them, and to the surface.
struct OutsideStrain {
  Box surface;                          // where the displacement is known: all of the grid along x
  std::array<Field, 3> displacement{};  // by axis, [i][j] of that; empty: nothing acts
  std::vector<Field> stress;  // by zone, [component][k][i][j] of its box; none: nothing acts
};

/// zones: within the grid, from the mirror planes of the history on. axes: along which the
/// displacement is wanted.
OutsideStrain outside_strain(const Scene& scene, int body, const PlasticState& history,
                             const Zones& zones, operators::ResidualMethod method,
                             std::span<const operators::Axis> axes = operators::normal_axis);

/// The same by the operators of zones, which may reach beyond the grid. Without mirror planes.
OutsideStrain outside_strain_in_zones(
    const std::shared_ptr<const operators::ZoneTables>& tables, const PlasticState& history,
    const Zones& zones, int reach, std::span<const operators::Axis> axes = operators::normal_axis);

}  // namespace samcontact::simulation
