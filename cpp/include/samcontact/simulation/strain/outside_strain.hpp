// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of plastic strain outside the zones, such as the wake of a moving contact.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// Stress in the zones and surface displacement due to the strain outside them.
struct OutsideStrain {
  Box surface;  // surface cells with known displacement: all of the grid along x
  std::array<Field, 3> displacement{};  // by axis, [i][j] of these cells [m]; empty: 0
  std::vector<Field> stress;            // by zone, [component][k][i][j] of its box [Pa]; none: 0
};

/// zones: within the grid, on one side of the mirror planes of the history. axes: of the required
/// displacement.
OutsideStrain outside_strain(const Setup& setup, int body, const PlasticState& history,
                             const Zones& zones, operators::ResidualMethod method,
                             std::span<const operators::Axis> axes = operators::normal_axis);

/// Counterpart with the operators of zones, which may extend beyond the grid. Without mirror
/// planes.
OutsideStrain outside_strain_in_zones(
    const std::shared_ptr<const operators::ZoneTables>& tables, const PlasticState& history,
    const Zones& zones, int reach, std::span<const operators::Axis> axes = operators::normal_axis);

}  // namespace samcontact::simulation
