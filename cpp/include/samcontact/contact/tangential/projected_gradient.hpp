// SPDX-License-Identifier: GPL-3.0-or-later
// Accelerated projected gradients for partial slip: slow, but descending for any sets of sticking
// and slipping cells.
#pragma once

#include <vector>

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// Nearest shear within the bounds that has the prescribed forces: v + sum of c_k direction_k, cut
/// to the bounds. The c are found by Newton's method on a convex function of at most three numbers;
/// they start from `multipliers`. False if no shear has the prescribed forces.
bool project(const ShearProblem& problem, Field& v, std::vector<double>& multipliers);

/// At most max_steps steps from a shear, or until the natural residual is below tol (Beck &
/// Teboulle 2009, doi:10.1137/080716542, restarted if the descent reverses). The step length is
/// safe: the largest eigenvalue of C is bounded by power iteration.
void projected_gradient(const ShearProblem& problem, ShearApplier& operators, double tol,
                        int max_steps, ShearResult& result);

}  // namespace samcontact::contact
