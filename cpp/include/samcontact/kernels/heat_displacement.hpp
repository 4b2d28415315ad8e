// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement of a half-space due to a rectangle of uniform heat flux, for any
// heating time and velocity.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/heat_source.hpp"

namespace samcontact::kernels {

/// k u_z / (alpha (1 + nu) q) [length^2], table [i][j]; u_z is positive into the body, hence
/// negative: heated surfaces bulge. It vanishes at infinity; a steady stationary source has no such
/// solution and is rejected with std::invalid_argument (see steady_heat_displacement). From the
/// temperature by reciprocity with Boussinesq's point force, as in Boucly (2008), eq. (2.45), with
/// sign and power corrected; the integrals over depth and space are evaluated in closed form. The
/// error is about tol times the largest value.
Field heat_displacement(const HeatSource& source, const HeatPoints& points, double tol);

}  // namespace samcontact::kernels
