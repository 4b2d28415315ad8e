// SPDX-License-Identifier: GPL-3.0-or-later
// Rectangles of the surface with tractions, and the part of tractions over a box.
#pragma once

#include "samcontact/base/box.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::simulation {

/// Rectangle of the grid cells with tractions; no layers.
Box window_of(const operators::Tractions& tractions, const Grid& grid);
/// Part of the surface fields over a box; 0 beyond the grid.
operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box);
/// Shear [2][i][j] [Pa]; empty without shear.
Field shear_vectors(const operators::Tractions& tractions);

}  // namespace samcontact::simulation
