// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of a cuboid with uniform eigenstrain (plastic strain) in a half-space: displacement of
// the surface and stress anywhere. Corner functions; sums in corners.hpp.
//
// Lengths in one unit. Strain components xx, yy, zz, yz, xz, xy are tensor components and each
// shear component is counted once (the factor 2 of its transpose is inside the kernels).
#pragma once

#include <array>

#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::kernels {

/// Corner functions D_I of the surface displacement: u_z = 1/(2 pi) sum_I eps_I S3[D_I], with x, y
/// = field minus source and z = depth of the corner. Parities in (x, y): xx, yy, zz even-even, yz
/// even-odd, xz odd-even, xy odd-odd. Boucly (2008), eqs (2.64)-(2.71), with (2.68) corrected and
/// a term for the trace added, so that any symmetric strain is allowed.
std::array<double, 6> eigenstrain_displacement(double x, double y, double z, double nu);

/// Corner functions H_I of the displacement along the surface: u_x = 1/(2 pi) sum_I eps_I S3[H_I],
/// arguments as above. Parities in (x, y): xx, yy, zz odd-even, yz odd-odd, xz even-even, xy
/// even-odd. For u_y exchange x and y, xx and yy, yz and xz. By reciprocity, the stress of a unit
/// shear force (shear_stress()) integrated over the cuboid: docs/theory/half_space.md.
std::array<double, 6> eigenstrain_side_displacement(double x, double y, double z, double nu);

constexpr int full_space_count = 15;
constexpr int image_count = 43;

/// Fourth derivatives of R integrated over the cuboid, argument (X, Y, z_field - z_corner): xxxx,
/// yyyy, zzzz, xxxy, xxxz, xyyy, yyyz, xzzz, yzzz, xxyy, xxzz, yyzz, xxyz, xyyz, xyzz. The parity
/// in each direction is that of the number of its indices.
std::array<double, full_space_count> full_space_scalars(double x, double y, double z);

/// Kernels of the image part, argument (X, Y, z_field + z_corner), z > 0: derivatives of the
/// potentials chi (9), z theta (9), phi (7, third derivatives), z phi (9), phi (9), where phi =
/// 1/R, theta = ln(R + z), chi = z theta - R.
std::array<double, image_count> image_scalars(double x, double y, double z);

/// Number of indices x (direction 0), y (1) or z (2) of a scalar kernel: its parity.
struct Parity {
  bool odd_x, odd_y, odd_z;
};
Parity full_space_parity(int kernel);
Parity image_parity(int kernel);
/// Parity of a stress or strain component as a scalar source of symmetric fields.
Parity component_parity(int component);

/// Stress [Pa] per unit eigenstrain, [out][in], of a cuboid with centre depth zc and half sizes a,
/// b, c, at X, Y (field minus source) and depth z >= 0. Inside the cuboid the stress that would
/// correspond to the eigenstrain itself is subtracted; if the cuboid touches the free surface, the
/// limit from inside is taken there.
std::array<std::array<double, 6>, 6> eigenstrain_stress(double X, double Y, double z, double zc,
                                                        double a, double b, double c, double E,
                                                        double nu);

/// Term subtracted inside the source: sigma_out -= inside_stress(out, in, nu) G eps_in.
double inside_stress(int out, int in, double nu);

}  // namespace samcontact::kernels
