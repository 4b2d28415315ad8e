// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that tangential forces and torque are below the friction limit.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"

namespace samcontact::contact {

/// Names of the tangential motions and of the rotation, for messages.
struct MotionNames {
  const char *along, *rotation;
};
inline constexpr MotionNames increment_motions{"shift", "twist"},
    rolling_motions{"creepage", "spin"};

/// Throws std::invalid_argument if the force exceeds the friction limit for any pressure with this
/// load [N].
void require_held(const TangentialDrive& drive, const FrictionLaw& friction, double load,
                  const MotionNames& motions);

/// factor: of the bounds of the cells; empty: 1.
/// Throws std::invalid_argument if forces or torque exceed the friction limit under a given
/// pressure, individually or together, or if a law without slip cannot attain a prescribed motion.
void require_held(const Grid& grid, const TangentialDrive& drive, const Field& pressure,
                  const FrictionLaw& friction, const Field& factor, const MotionNames& motions);

}  // namespace samcontact::contact
