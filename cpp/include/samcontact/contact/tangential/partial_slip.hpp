// SPDX-License-Identifier: GPL-3.0-or-later
// Partial slip under a given pressure by an inexact semismooth Newton iteration: slipping cells
// rotate on their circle, sticking cells move freely, the linear systems are solved by
// preconditioned conjugate gradients, and cells change between both sets.
#pragma once

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// Solves until the natural residual is below tol. If the sets do not settle, projected gradients,
/// which always descend, are used. Returns converged = false after max_steps.
ShearResult solve_partial_slip(const ShearProblem& problem, ShearApplier& operators,
                               ShearStart start, double tol, int max_steps);

}  // namespace samcontact::contact
