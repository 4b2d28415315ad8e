// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a homogeneous half-space due to the modes of its heat history: closed forms, with the
// wavenumbers along the depth as nodes.
#pragma once

#include <memory>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/operators/heat/heat_response.hpp"

namespace samcontact::operators {

/// dx: unit of the lengths of `modes` [m]. Keeps a reference to them.
std::unique_ptr<const HeatResponse> half_space_response(const HeatModes& modes, double dx,
                                                        const Thermal& thermal,
                                                        const Elastic& elastic);

}  // namespace samcontact::operators
