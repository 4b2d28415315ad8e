// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions of a half-space for a Fourier mode of surface traction of unit amplitude,
// exp(i (kx x + ky y)), and corner functions of loads that are uniform along y: periodic surfaces
// need them in addition to the coefficients of one rectangle. docs/theory/periodic.md.
#pragma once

#include <array>

#include "samcontact/kernels/surface_traction.hpp"

namespace samcontact::kernels {

/// Real factor Q of the spectrum (-i)^n Q of a field that is odd in n of x and y. kx, ky >= 0 and
/// not both 0 [1/m]. Surface displacement times the shear modulus [m]: along x, y and z.
std::array<double, 3> pressure_wave_displacement(double kx, double ky, double nu);
std::array<double, 3> shear_wave_displacement(double kx, double ky, double nu);
/// Stress at depth z >= 0 [m].
Stress pressure_wave_stress(double kx, double ky, double z, double nu);
Stress shear_wave_stress(double kx, double ky, double z, double nu);

/// Means over depths z0 < z < z1 of pressure_wave_stress and of shear_wave_stress.
Stress pressure_wave_mean(double kx, double ky, double z0, double z1, double nu);
Stress shear_wave_mean(double kx, double ky, double z0, double z1, double nu);

/// Corner functions in x of the stress below a strip -a < x < a: sigma = traction/pi (F(x + a) -
/// F(x - a)), for pressure, shear along x and shear along y. Johnson (1985), sec. 2.5; the last one
/// is antiplane.
Stress strip_pressure_stress(double x, double z, double nu);
Stress strip_shear_stress(double x, double z, double nu);
Stress strip_antiplane_stress(double x, double z);

/// Counterpart of eigenstrain_displacement for a bar with corner depths z: u_z = 1/pi S_2[D].
std::array<double, 6> bar_displacement(double x, double z, double nu);
/// Displacement of a bar across, u_x, and along, u_y.
std::array<double, 6> bar_displacement_across(double x, double z, double nu);
std::array<double, 6> bar_displacement_along(double x, double z);

}  // namespace samcontact::kernels
