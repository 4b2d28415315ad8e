// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal coefficients of one cell of a layered half-space: closed forms of the layer, and the
// remainder by Fourier modes. Layers that do not differ have the closed forms only.
#pragma once

#include <array>

#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::operators {

/// Counterparts of heat_displacement() and others in heating.hpp. In the steady state they throw
/// std::invalid_argument for layers that differ and move neither along x nor along y.
ParityParts layered_heat_displacement(const Stack& elastic, const Heating& heating, double dx,
                                      double dy, const Offsets& offsets);
/// On an interface, in the layer below it.
std::array<ParityParts, 6> layered_heat_stress(const Stack& elastic, const Heating& heating,
                                               double dx, double dy, double z,
                                               const Offsets& offsets);
ParityParts layered_heat_temperature(const Heating& heating, double dx, double dy, double z,
                                     const Offsets& offsets);

}  // namespace samcontact::operators
