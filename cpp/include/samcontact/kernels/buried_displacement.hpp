// SPDX-License-Identifier: GPL-3.0-or-later
// Corner functions of waves exp(-q d)/q: the displacement of a surface that sees a load from a
// distance d, as a thick coating sees the substrate. At d = 0 those of surface_traction.hpp.
#pragma once

namespace samcontact::kernels {

/// Sums over corners count 1/(2 pi). Factors of exp(-q d)/q, with c and s the direction of the
/// wave: 1, c^2, c s and c, in the sense of kernels/wave.hpp.
double buried_displacement(double x, double y, double d);
double buried_along(double x, double y, double d);
double buried_across(double x, double y, double d);
double buried_coupling(double x, double y, double d);

}  // namespace samcontact::kernels
