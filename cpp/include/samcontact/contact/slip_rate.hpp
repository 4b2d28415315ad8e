// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that depends on the slip rate or on the place: bounds of the cells, and the fixed point
// of the slip rate.
#pragma once

#include <functional>

#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

/// Coefficient of friction of each cell relative to the largest; moved_x, moved_y: distances by
/// which the body has moved towards -x and -y [m].
Field factor_on(const MappedCoulomb& map, const Grid& grid, double moved_x, double moved_y);

/// Iterates the slip rate until the friction of each cell is that of its slip rate. The iteration
/// starts from the slip rate of the conditions. Throws std::invalid_argument without a duration,
/// and for a falling number above 1 without memory unless the conditions select a solution;
/// ConvergenceError if the slip rate does not converge.
PartialSlipSolution solve_with_slip_rate(const SlipRateLaw& law, const Grid& grid,
                                         const SolveUnder& solve, Field pressure,
                                         const PartialSlipStart& start,
                                         const FrictionConditions& given,
                                         const RateSettings& settings,
                                         const std::function<double(bool)>& self_influence);

}  // namespace samcontact::contact
