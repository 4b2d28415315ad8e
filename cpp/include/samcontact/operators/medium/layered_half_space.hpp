// SPDX-License-Identifier: GPL-3.0-or-later
// Layers on a substrate: a medium with coefficients from its waves.
#pragma once

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Neighbours that are alike are one; a half_space() where only the substrate is left.
SharedMedium medium_of(const Stack& stack);

}  // namespace samcontact::operators
