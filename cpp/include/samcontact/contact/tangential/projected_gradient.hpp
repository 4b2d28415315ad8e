// SPDX-License-Identifier: GPL-3.0-or-later
// Accelerated projected gradients for stick and slip: slow, but they descend whatever the sets do.
#pragma once

#include <vector>

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// The nearest shear within the bounds whose forces are given: v + sum of c_k direction_k, cut. The
/// c are found by Newton's method on a convex function of three numbers at most; they start from
/// `multipliers`. False where no shear has the forces.
bool project(const ShearProblem& problem, Field& v, std::vector<double>& multipliers);

/// At most so many steps from a shear, or until the natural residual is below tol (Beck & Teboulle
/// 2009, doi:10.1137/080716542, restarted where the descent turns). Their length is safe: the
/// largest eigenvalue of C is bounded by power iteration.
void projected_gradient(const ShearProblem& problem, ShearApplier& operators, double tol,
                        int most_steps, ShearResult& result);

}  // namespace samcontact::contact
