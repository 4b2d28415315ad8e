// SPDX-License-Identifier: GPL-3.0-or-later
// Forces along the surface that friction cannot hold are refused, by name.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"

namespace samcontact::contact {

/// Names of the motions along the surface, and of the turn.
struct MotionNames {
  const char *along, *turn;
};
inline constexpr MotionNames increment_motions{"shift", "twist"},
    rolling_motions{"creepage", "spin"};

/// Throws std::invalid_argument where no shear has the force, under any pressure of this load [N].
void require_held(const TangentialDrive& drive, const FrictionLaw& friction, double load,
                  const MotionNames& motions);

/// The same under a pressure, of the torque too, and of both together.
void require_held(const Grid& grid, const TangentialDrive& drive, const Field& pressure,
                  const FrictionLaw& friction, const MotionNames& motions);

}  // namespace samcontact::contact
