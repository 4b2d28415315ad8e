// SPDX-License-Identifier: GPL-3.0-or-later
// Criteria of high-cycle fatigue that look at the path of the stress deviator.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/fatigue/paths.hpp"

namespace samcontact::fatigue {

/// Dang Van: the largest, over the cycle, of tau + slope times the mean normal stress. tau is half
/// the difference of the largest and smallest principal value of s - s*, s* the centre of the
/// smallest ball around the path of the deviator s. [cell] [Pa]. Ballard, Dang Van, Deperrois &
/// Papadopoulos (1995), doi:10.1111/j.1460-2695.1995.tb00886.x.
Field dang_van(const Paths& stress, double slope);

/// Crossland: amplitude of the square root of the second invariant, which is the radius of that
/// ball, + slope times the largest mean normal stress. [cell] [Pa]. Papadopoulos, Davoli, Gorla,
/// Filippini & Bernasconi (1997), Int. J. Fatigue 19, 219-235.
Field crossland(const Paths& stress, double slope);

}  // namespace samcontact::fatigue
