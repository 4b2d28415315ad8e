// SPDX-License-Identifier: GPL-3.0-or-later
// What one cell of a half-space does to the cells around it: tables from closed forms, and all that
// lattice sums of them need.
#pragma once

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/periodic_sums.hpp"
#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::operators {

/// In x and y: odd in a direction that one of traction and displacement has and the other not.
kernels::Parity compliance_parity(Traction traction, Axis axis);

/// Displacement of the surface along an axis per unit traction [j][i] [m/Pa].
Field cell_compliance(const Elastic& elastic, Traction traction, Axis axis, const Grid& grid,
                      const CellOffsets& offsets);
CellInfluence compliance_of_cell(const Elastic& elastic, Traction traction, Axis axis,
                                 const Grid& grid);

/// Stress at a depth per unit traction on offsets 0..nx-1, 0..ny-1: [component][j][i] [-].
Field cell_stress(double nu, Traction traction, const Grid& grid, int nx, int ny, double z,
                  Tensor tensor);
/// The same at any offsets.
Field cell_stress(double nu, Traction traction, const Grid& grid, const CellOffsets& offsets,
                  double z, Tensor tensor);
CellInfluence stress_of_cell(double nu, Traction traction, const Grid& grid, double z);

/// u_z of the surface per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell of a layer,
/// [component][j][i] [m].
Field cell_residual_displacement(double nu, const Grid& grid, const CellOffsets& offsets,
                                 int layer);
/// u_z of the surface per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell of a layer [m].
CellInfluence residual_of_cell(double nu, const Grid& grid, int layer);

}  // namespace samcontact::operators
