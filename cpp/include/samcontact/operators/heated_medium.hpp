// SPDX-License-Identifier: GPL-3.0-or-later
// A medium whose volume also feels the heat that a pressure brings: what pressure does to it is
// what pressure, heat and, where the source moves, friction do.
#pragma once

#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

/// heating: of a source that moves along x at most. shear: s_x over the pressure. Knows the volume
/// only, and tractions_on_heated(); the medium itself without heat.
SharedMedium heated(const SharedMedium& medium, const Heating& heating, double shear);

/// Where the source moves, the place of the shear is taken by the pressure itself: what it does
/// there is all that is odd in x, of the shear that goes with it and of heat. Its sign is then 1.
Tractions tractions_on_heated(const Tractions& tractions, const Heating& heating);
inline double shear_sign_on_heated(double sign, const Heating& heating) {
  return heating.is_moving() ? 1.0 : sign;
}

}  // namespace samcontact::operators
