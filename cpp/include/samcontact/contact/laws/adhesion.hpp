// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of adhesion: attraction that decreases with the gap, with a finite work of adhesion.
#pragma once

#include <vector>

#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {

/// a(g) = w/range exp(-g/range). work: of adhesion w [J/m^2]. All functions throw
/// std::invalid_argument for parameters that are not positive and finite.
SharedContactLaw exponential_adhesion(double work, double range);

/// a = stress up to a gap, then half a cosine wave to 0 within the distance `drop` [m] (the
/// law of Maugis 1992 with a resolved drop); the integral is the work. Throws also for a drop
/// longer than 2 work/stress.
SharedContactLaw dugdale_adhesion(double work, double stress, double drop);

/// 9-3 law of Lennard-Jones between half-spaces, with a hard wall at its equilibrium distance z0:
/// a = 8 w/(3 z0) [(1 + g/z0)^-3 - (1 + g/z0)^-9].
SharedContactLaw lennard_jones_adhesion(double work, double z0);

/// Piecewise linear law. points: gap [m] and attraction [Pa] by turns, the first gap 0, the last
/// attraction 0. Throws for less than two points, gaps that do not increase, negative attractions,
/// and a law that never falls.
SharedContactLaw tabulated_adhesion(const std::vector<double>& points);

}  // namespace samcontact::contact
