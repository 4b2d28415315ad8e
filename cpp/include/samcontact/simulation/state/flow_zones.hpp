// SPDX-License-Identifier: GPL-3.0-or-later
// Zones in which the plastic strain of a state was last solved for.
#pragma once

#include <vector>

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Whether the plastic strain of a body was last solved for in small zones.
bool is_in_zones(const State& state, int body);
/// Whether the plastic strain was last solved for in small zones, and all stress is due to
/// tractions, sources and the strain in these zones.
bool has_zone_stress(const State& state, int body);
/// Whether the plastic strain was last solved for in boxes other than the box of its history.
bool is_elsewhere(const State& state, int body);
/// Disjoint boxes with all plastic strain of a body: those of the last solution, or one box of the
/// cells of its fields.
std::vector<Box> zones(const State& state, int body);

}  // namespace samcontact::simulation
