// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the surface on which tractions act.
#pragma once

#include "samcontact/base/box.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::simulation {

/// The cells of the grid where tractions act; no layers.
Box window_of(const operators::Tractions& tractions, const Grid& grid);
/// The part of the surface fields over a box; 0 beside the grid.
operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box);
/// Shear [2][i][j]; empty where there is none.
Field shear_vectors(const operators::Tractions& tractions);

}  // namespace samcontact::simulation
