// SPDX-License-Identifier: GPL-3.0-or-later
// Stick and slip under a given pressure by an inexact semismooth Newton iteration: slipping cells
// turn along their circle, sticking cells move freely, the linear systems are solved by
// preconditioned conjugate gradients, and cells change sides between them.
#pragma once

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// Solves until the natural residual is below tol. Where the sets do not settle, projected
/// gradients help, which always descend. Returns converged = false after most_steps.
ShearResult solve_stick_slip(const ShearProblem& problem, ShearApplier& operators, ShearStart start,
                             double tol, int most_steps);

}  // namespace samcontact::contact
