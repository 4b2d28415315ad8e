// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of one cell of a layered half-space: closed forms of the nearest layer,
// and the remainder by rings in wavenumber.
#pragma once

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/periodic/cell_influence.hpp"

namespace samcontact::operators {

/// Surface displacement along an axis per unit traction [j][i] [m/Pa], on a grid that is not
/// periodic.
Field layered_compliance(const Stack& stack, Traction traction, Axis axis, const Grid& grid,
                         const CellOffsets& offsets);

/// Stress at a depth per unit traction [component][j][i] [-]; on an interface, in the layer below
/// it.
Field layered_stress(const Stack& stack, Traction traction, const Grid& grid,
                     const CellOffsets& offsets, double z, Tensor tensor);

/// Both with the additional data of lattice sums.
CellInfluence layered_compliance_of_cell(const Stack& stack, Traction traction, Axis axis,
                                         const Grid& grid);
CellInfluence layered_stress_of_cell(const Stack& stack, Traction traction, const Grid& grid,
                                     double z);

/// Surface displacement along an axis per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell between
/// two depths inside one layer [component][j][i] [m].
Field layered_residual_displacement(const Stack& stack, Axis axis, const Grid& grid,
                                    const CellOffsets& offsets, int layer);
CellInfluence layered_residual_of_cell(const Stack& stack, Axis axis, const Grid& grid, int layer);

}  // namespace samcontact::operators
