// SPDX-License-Identifier: GPL-3.0-or-later
// Layers on a substrate: a medium with coefficients from its Fourier modes.
#pragma once

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Adjacent layers of identical material are merged; a half_space() if only the substrate is left.
SharedMedium medium_of(const Stack& stack);

}  // namespace samcontact::operators
