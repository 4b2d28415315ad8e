// SPDX-License-Identifier: GPL-3.0-or-later
// Stress in a half-space due to a rectangle of uniform heat flux, for any heating time and
// velocity.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/heat_source.hpp"

namespace samcontact::kernels {

/// k (1 - nu) sigma / (E alpha q) [length] at depth z, table [component][i][j], components xx, yy,
/// zz, yz, xz, xy, tension positive. zz, yz and xz are zero at z = 0, and for a steady stationary
/// source everywhere. Quasi-static thermoelasticity as in Liu & Wang (2003) and Boucly (2008),
/// appendix 1, as integrals over Gaussians. The error is about tol times the largest value.
Field heat_stress(const HeatSource& source, const HeatPoints& points, double z, double nu,
                  double tol);

}  // namespace samcontact::kernels
