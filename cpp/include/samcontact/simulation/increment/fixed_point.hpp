// SPDX-License-Identifier: GPL-3.0-or-later
// Solution of one increment: elastic trial first, then the plastic fixed-point iteration with
// Anderson mixing.
#pragma once

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

/// State after one increment. Throws ConvergenceError if the fixed-point iteration does not reach
/// settings.tol in settings.max_iterations evaluations.
State solve_increment(const IncrementTask& task);

}  // namespace samcontact::simulation
