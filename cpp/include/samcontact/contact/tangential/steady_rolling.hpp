// SPDX-License-Identifier: GPL-3.0-or-later
// Stick and slip of a contact that rolls steadily towards +x by one cell after the other: what
// slips is what came from the cell ahead and is displaced otherwise now.
#pragma once

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// The slip while the contact rolls by one cell is w = b - (1 - T) C s, T u the displacement of the
/// next cell ahead: not the gradient of anything, but stick and slip are the same. A problem with
/// `carried` one row of cells; rows run along +x. Semismooth Newton, in the motions of given forces
/// too; where the error does not fall, the contact is rolled by 4, 2, 1 cells at once until it is
/// steady, for which the box of the operators has `rolling_margin` rows of cells ahead. Returns
/// converged = false after most_steps.
ShearResult solve_steady_rolling(const ShearProblem& problem, ShearApplier& operators,
                                 ShearStart start, double tol, int most_steps);

constexpr int rolling_margin = 4;

}  // namespace samcontact::contact
