// SPDX-License-Identifier: GPL-3.0-or-later
// What one cell of a half-space does to the cells around it: tables from closed forms, and all that
// lattice sums of them need.
#pragma once

#include <array>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/periodic/periodic_sums.hpp"

namespace samcontact::operators {

/// In x and y: odd in a direction that one of traction and displacement has and the other not.
kernels::Parity compliance_parity(Traction traction, Axis axis);

/// Corner function of the displacement of the surface along an axis under a unit traction on a
/// rectangle, and what pi times the displacement over its corner sum is [1/Pa].
double compliance_corner(Traction traction, Axis axis, double x, double y, double nu);
double compliance_factor(const Elastic& elastic, Traction traction, Axis axis);
/// Displacement of the surface along an axis per unit traction [j][i] [m/Pa].
Field cell_compliance(const Elastic& elastic, Traction traction, Axis axis, const Grid& grid,
                      const CellOffsets& offsets);
CellInfluence compliance_of_cell(const Elastic& elastic, Traction traction, Axis axis,
                                 const Grid& grid);

/// The same of a stress component under a traction, and of the displacement which that works on
/// under the component as an eigenstrain.
kernels::Parity stress_parity(Traction traction, int component);

/// The displacement over that stress: seen from the other end, each shear with its transpose.
double betti_factor(Traction traction, int component);

/// The components of a tensor that a field has, first.
kernels::Stress select(kernels::Stress s, Tensor tensor);
/// The same of tables [component][plane].
Field selected(Field six, Tensor tensor);
/// Stress under a wave of a traction at a depth, and its mean over depths, in the sense of
/// kernels/wave.hpp.
kernels::Stress wave_stress(Traction traction, double kx, double ky, double z, double nu);
kernels::Stress wave_mean(Traction traction, double kx, double ky, double z0, double z1, double nu);

/// Corner functions of the stress under a unit traction on a rectangle, whose corner sum counts
/// 1/(2 pi).
kernels::Stress stress_corner(Traction traction, double x, double y, double z, double nu);
/// Stress at a depth per unit traction: [component][j][i] [-].
Field cell_stress(double nu, Traction traction, const Grid& grid, const CellOffsets& offsets,
                  double z, Tensor tensor);
CellInfluence stress_of_cell(double nu, Traction traction, const Grid& grid, double z);

/// Displacement of the surface along an axis per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell
/// of a layer: corner functions, whose sum over the eight corners counts 1/(2 pi), and tables
/// [component][j][i] [m].
std::array<double, 6> residual_corner(Axis axis, double x, double y, double z, double nu);
Field cell_residual_displacement(double nu, Axis axis, const Grid& grid, const CellOffsets& offsets,
                                 int layer);
CellInfluence residual_of_cell(double nu, Axis axis, const Grid& grid, int layer);

}  // namespace samcontact::operators
