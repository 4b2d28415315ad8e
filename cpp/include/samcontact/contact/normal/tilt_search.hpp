// SPDX-License-Identifier: GPL-3.0-or-later
// Search for the tilts at which the pressure of a contact has given moments.
#pragma once

#include <functional>

#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/drive.hpp"

namespace samcontact::contact {

/// Solution for a drive that holds the tilts, from an initial pressure.
using SolveHeld = std::function<Solution(const Drive& held, const Field& initial_pressure)>;

/// Scales of a tilt search: first change of a tilt times the size of the contact, and the largest
/// change of a tilt in a step, likewise [m].
struct TiltSteps {
  double first, largest;
};

/// Solution with the prescribed moments (Broyden's method on the tilts). first: tilts from which
/// the search starts. The solution has not converged if the search finds no smaller error, e.g. if
/// the moments do not depend on the tilts.
Solution find_tilts(const Grid& grid, const Drive& drive, const AboutAxes& first,
                    const Field& initial_pressure, const TiltSteps& steps, double tol,
                    const SolveHeld& solve);

/// Tilts of the plane that fits a field best over the cells with pressure [rad]; 0 about axes for
/// which these cells determine no slope.
AboutAxes tilts_of(const Grid& grid, const Field& field, const Field& pressure);

}  // namespace samcontact::contact
