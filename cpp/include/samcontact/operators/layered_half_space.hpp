// SPDX-License-Identifier: GPL-3.0-or-later
// Layers on a substrate: a medium with coefficients from its waves.
#pragma once

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

/// Neighbours that are alike are one; a half_space() where only the substrate is left. What layers
/// do not serve throws std::invalid_argument: heat.
SharedMedium medium_of(const Stack& stack);

}  // namespace samcontact::operators
