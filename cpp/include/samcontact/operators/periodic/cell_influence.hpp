// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of one cell of a half-space: tables from closed forms, and the additional
// data of their lattice sums.
#pragma once

#include <array>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/periodic/periodic_sums.hpp"

namespace samcontact::operators {

/// Parity in x and y: odd in a direction that occurs in exactly one of traction and displacement.
kernels::Parity compliance_parity(Traction traction, Axis axis);

/// Corner function of the surface displacement along an axis due to a unit traction on a rectangle,
/// and pi times the displacement over its corner sum [1/Pa].
double compliance_corner(Traction traction, Axis axis, double x, double y, double nu);
double compliance_factor(const Elastic& elastic, Traction traction, Axis axis);
/// Surface displacement along an axis per unit traction [j][i] [m/Pa].
Field cell_compliance(const Elastic& elastic, Traction traction, Axis axis, const Grid& grid,
                      const CellOffsets& offsets);
CellInfluence compliance_of_cell(const Elastic& elastic, Traction traction, Axis axis,
                                 const Grid& grid);

/// Parity of a stress component due to a traction, and of the work-conjugate displacement due to
/// that component as an eigenstrain.
kernels::Parity stress_parity(Traction traction, int component);

/// Ratio of the displacement due to an eigenstrain component to the stress component due to a
/// traction, by Betti's theorem; each shear component is counted with its transpose.
double betti_factor(Traction traction, int component);

/// Index of each stored component after x and y are exchanged.
const std::array<std::size_t, 6>& exchanged_places(Tensor tensor);
/// Moves the components that a field of this kind stores to the front.
kernels::Stress select(kernels::Stress s, Tensor tensor);
/// Selected components of tables [component][plane].
Field selected(Field six, Tensor tensor);
/// Stress due to a Fourier mode of a traction at a depth, and its mean over depths, as defined in
/// kernels/wave.hpp.
kernels::Stress wave_stress(Traction traction, double kx, double ky, double z, double nu);
kernels::Stress wave_mean(Traction traction, double kx, double ky, double z0, double z1, double nu);

/// Corner functions of the stress due to a unit traction on a rectangle; the corner sum is to be
/// multiplied by 1/(2 pi).
kernels::Stress stress_corner(Traction traction, double x, double y, double z, double nu);
/// Stress at a depth per unit traction: [component][j][i] [-].
Field cell_stress(double nu, Traction traction, const Grid& grid, const CellOffsets& offsets,
                  double z, Tensor tensor);
CellInfluence stress_of_cell(double nu, Traction traction, const Grid& grid, double z);

/// Surface displacement along an axis per unit eigenstrain xx, yy, zz, yz, xz, xy in a cell of a
/// layer: corner functions, whose sum over the eight corners is to be multiplied by 1/(2 pi), and
/// tables [component][j][i] [m].
std::array<double, 6> residual_corner(Axis axis, double x, double y, double z, double nu);
Field cell_residual_displacement(double nu, Axis axis, const Grid& grid, const CellOffsets& offsets,
                                 int layer);
CellInfluence residual_of_cell(double nu, Axis axis, const Grid& grid, int layer);

}  // namespace samcontact::operators
