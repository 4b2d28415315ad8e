// SPDX-License-Identifier: GPL-3.0-or-later
// Where the plastic strain of a state was last solved for.
#pragma once

#include <vector>

#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Whether the plastic strain of a body was last solved for in small zones.
bool is_in_zones(const State& state, int body);
/// The same, and all stress is that of the strain, of tractions and of sources.
bool shows_zones(const State& state, int body);
/// Whether it was last solved for elsewhere than in the one box of its history.
bool is_elsewhere(const State& state, int body);
/// Disjoint boxes with all plastic strain of a body: those it was solved for in, or one box of
/// what fields show.
std::vector<Box> zones(const State& state, int body);

}  // namespace samcontact::simulation
