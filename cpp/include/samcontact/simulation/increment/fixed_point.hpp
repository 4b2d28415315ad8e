// SPDX-License-Identifier: GPL-3.0-or-later
// Solves one increment: elastic trial first, then the plastic fixed point with Anderson mixing.
#pragma once

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

/// The state after one increment. Throws ConvergenceError when the fixed point does not reach
/// settings.tol in settings.max_iterations evaluations.
State solve_increment(const IncrementTask& task);

}  // namespace samcontact::simulation
