// SPDX-License-Identifier: GPL-3.0-or-later
// Steady state of a half-space under a stationary rectangle of uniform heat flux q [W/m^2] (into
// the body, the rest of the surface insulated), in closed form.
//
// x, y: field point minus centre of the rectangle |x| <= a, |y| <= b; z >= 0 depth; all in one unit
// of length. Conductivity k [W/(m K)], expansion alpha [1/K]. Finite everywhere, including edges
// and corners. Even in x and in y, except sigma_xy, which is odd in both.
#pragma once

#include <array>

namespace samcontact::kernels {

/// k T / q [length], T the temperature rise [K]. Carslaw & Jaeger (1959), section 10.5.
double steady_heat_temperature(double x, double y, double z, double a, double b);

/// k sigma / (E alpha q) [length], xx, yy, xy; zz, xz and yz vanish everywhere. Tension positive.
/// Sternberg & McDowell (1957).
std::array<double, 3> steady_heat_stress(double x, double y, double z, double a, double b);

/// k u_z / (alpha (1 + nu) q) [length^2] of the surface, positive into the body, relative to the
/// displacement of a point source at the distance r0: u_z has no limit at infinity. Johnson (1985),
/// section 12.2.
double steady_heat_displacement(double x, double y, double a, double b, double r0);
/// Counterpart whose Fourier mode is exp(-q d) times that of steady_heat_displacement, d > 0: a
/// smooth field with the same far field; ln(r/r0) of a point source becomes ln((R + d)/r0).
double buried_heat_displacement(double x, double y, double d, double a, double b, double r0);

}  // namespace samcontact::kernels
