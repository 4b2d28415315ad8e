// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of layers on a substrate due to the modes of their heat history. The response of a
// wavenumber to a pulse of heat decays as a sum of exponentials whose rates are the nodes of its
// block; their weights are fitted to the inverse Laplace transform (docs/theory/heat.md).
#pragma once

#include <memory>

#include "samcontact/base/thermal_stack.hpp"
#include "samcontact/operators/heat/heat_response.hpp"

namespace samcontact::operators {

/// dx: unit of the lengths of `modes` [m]. diffusivity: that of their times [m^2/s]. Keeps a
/// reference to them.
std::unique_ptr<const HeatResponse> layered_response(const HeatModes& modes, double dx,
                                                     double diffusivity, const HeatedStack& stack);

}  // namespace samcontact::operators
