// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of uniform tractions on a rectangle of the half-space surface: u_z at the surface
// (Love, Cerruti) and stress at any depth. Corner functions; sums in corners.hpp.
//
// x, y: field point minus corner of the source, z >= 0 depth, all in one unit of length. Only the
// corner sum of a function is meaningful; terms that the sum annihilates are omitted.
#pragma once

#include <array>

namespace samcontact::kernels {

/// Six stress components xx, yy, zz, yz, xz, xy.
using Stress = std::array<double, 6>;

/// Corner function of u_z due to pressure: u_z = p (1 - nu^2)/(pi E) S2. Even in x, even in y.
/// Love (1929), see Boucly (2008), eq. (2.34).
double pressure_displacement(double x, double y);

/// Corner function of u_z due to shear s_x (acting on the body along +x): u_z = s_x (1 + nu)(1 - 2
/// nu)/(2 pi E) S2. Odd in x, even in y. Cerruti (1882); the prefactor in Boucly (2008), eq.
/// (2.37), lacks (1 - 2 nu)/4.
double shear_displacement(double x, double y);

/// Corner functions of the displacement in the surface due to shear s_x: u_x = s_x/(2 pi G) S2
/// along it, even in x and y, and u_y = s_x/(2 pi G) S2 across, odd in x and y. Cerruti's point
/// force, Johnson (1985), sec. 3.6, integrated.
double along_displacement(double x, double y, double nu);
double cross_displacement(double x, double y, double nu);

/// Corner functions of the stress due to pressure: sigma = p/(2 pi) S2. Parities in (x, y):
/// xx, yy, zz even-even, yz even-odd, xz odd-even, xy odd-odd. Boucly (2008), eqs (2.81)-(2.86).
Stress pressure_stress(double x, double y, double z, double nu);

/// Corner functions of the stress due to shear s_x: sigma = s_x/(2 pi) S2. The parities in y equal
/// the parities of pressure_stress; those in x are opposite. Boucly (2008), eqs (2.88)-(2.93) with
/// L_22 corrected. For s_y exchange x and y, xx and yy, yz and xz.
Stress shear_stress(double x, double y, double z, double nu);

}  // namespace samcontact::kernels
