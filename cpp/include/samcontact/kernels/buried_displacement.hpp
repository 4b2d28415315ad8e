// SPDX-License-Identifier: GPL-3.0-or-later
// Corner functions of Fourier modes exp(-q d)/q: displacement of a surface due to a load at a
// distance d, e.g. on the substrate below a thick coating. For d = 0 they equal the functions of
// surface_traction.hpp.
#pragma once

namespace samcontact::kernels {

/// The corner sums are to be multiplied by 1/(2 pi). Factors of exp(-q d)/q, with the direction c,
/// s of the wavevector: 1, c^2, c s and c, as defined in kernels/wave.hpp.
double buried_displacement(double x, double y, double d);
double buried_along(double x, double y, double d);
double buried_across(double x, double y, double d);
double buried_coupling(double x, double y, double d);

}  // namespace samcontact::kernels
