// SPDX-License-Identifier: GPL-3.0-or-later
// High-cycle fatigue criteria based on the path of the stress deviator.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/fatigue/paths.hpp"

namespace samcontact::fatigue {

/// Dang Van: maximum over the cycle of tau + slope times the mean normal stress, where tau is half
/// the difference of the largest and smallest principal value of s - s*, and s* the centre of the
/// smallest ball around the path of the deviator s. [cell] [Pa]. Ballard, Dang Van, Deperrois &
/// Papadopoulos (1995), doi:10.1111/j.1460-2695.1995.tb00886.x.
Field dang_van(const Paths& stress, double slope);

/// Crossland: amplitude of the square root of the second invariant (the radius of the smallest ball
/// around the path) + slope times the maximum mean normal stress. [cell] [Pa]. Papadopoulos,
/// Davoli, Gorla, Filippini & Bernasconi (1997), Int. J. Fatigue 19, 219-235.
Field crossland(const Paths& stress, double slope);

}  // namespace samcontact::fatigue
