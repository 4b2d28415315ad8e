// SPDX-License-Identifier: GPL-3.0-or-later
// Solves one increment: elastic trial first, then the plastic fixed point with Anderson mixing.
#pragma once

#include <string>

#include "samcontact/simulation/simulation.hpp"

namespace samcontact::simulation {

/// The target in words, for messages.
std::string describe(const Target& target);

/// The state after one increment. Throws ConvergenceError when the fixed point does not reach
/// settings.tol in settings.max_iterations evaluations.
State solve_increment(const State& from, const Target& target, const Scans& scans,
                      const Settings& settings, Counters& counters);

}  // namespace samcontact::simulation
