// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous half-space: a medium with closed forms for all coefficients.
#pragma once

#include "samcontact/base/elastic.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// E = infinity gives a rigid body: its compliance is 0, and it has no other fields.
SharedMedium half_space(const Elastic& elastic);

}  // namespace samcontact::operators
