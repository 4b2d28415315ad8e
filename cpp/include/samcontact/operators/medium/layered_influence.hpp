// SPDX-License-Identifier: GPL-3.0-or-later
// What one cell of a layered half-space does to the cells around it: closed forms of the layer that
// is near, and the rest by rings in wavenumber.
#pragma once

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/periodic/cell_influence.hpp"

namespace samcontact::operators {

/// Displacement of the surface along an axis per unit traction [j][i] [m/Pa], of a grid without
/// period.
Field layered_compliance(const Stack& stack, Traction traction, Axis axis, const Grid& grid,
                         const CellOffsets& offsets);

/// Stress at a depth per unit traction [component][j][i] [-]; on an interface that below it.
Field layered_stress(const Stack& stack, Traction traction, const Grid& grid,
                     const CellOffsets& offsets, double z, Tensor tensor);

/// Of both what lattice sums need.
CellInfluence layered_compliance_of_cell(const Stack& stack, Traction traction, Axis axis,
                                         const Grid& grid);
CellInfluence layered_stress_of_cell(const Stack& stack, Traction traction, const Grid& grid,
                                     double z);

/// Displacement of the surface along an axis per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell
/// between two depths inside one layer [component][j][i] [m].
Field layered_residual_displacement(const Stack& stack, Axis axis, const Grid& grid,
                                    const CellOffsets& offsets, int layer);
CellInfluence layered_residual_of_cell(const Stack& stack, Axis axis, const Grid& grid, int layer);

}  // namespace samcontact::operators
