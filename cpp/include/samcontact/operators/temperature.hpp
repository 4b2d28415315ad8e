// SPDX-License-Identifier: GPL-3.0-or-later
// Rise of temperature in a body that frictional heat enters.
#pragma once

#include <span>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/heating.hpp"

namespace samcontact::operators {

/// Rise [depth][i][j] [K] at depths [m] under a pressure [i][j] [Pa].
Field temperature(const Grid& grid, const Heating& heating, std::span<const double> depths,
                  const double* pressure);

}  // namespace samcontact::operators
