// SPDX-License-Identifier: GPL-3.0-or-later
// Normal contact with an operator that is monotone but not symmetric: sets of contact cells, and on
// each set GMRES with the inverse of each Fourier mode as preconditioner.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/operators/surface/creeping_displacement.hpp"

namespace samcontact::contact {

/// Solves p >= 0, g >= 0, p g = 0 for a load or an approach, without tilts. Starts from `pressure`,
/// or from a uniform pressure if that is zero everywhere. Returns converged = false after
/// max_iterations. Cells of infinite gap (no body) stay out of contact. rounding: gaps up to this
/// value count as closed [m].
Solution solve_monotone(const operators::CreepingDisplacement& displacement, const Grid& grid,
                        const Field& initial_gap, const Given& normal, Field pressure,
                        double rounding, double tol, int max_iterations);

}  // namespace samcontact::contact
