// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained conjugate gradient method without preconditioner: slow but robust, for problems in
// which the active-set iteration does not settle.
#pragma once

#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/rigid_modes.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"

namespace samcontact::contact {

/// Conjugate gradient on the cells in contact with projection to p >= 0 (Polonsky & Keer 1999,
/// doi:10.1016/S0043-1648(99)00113-1), for given load and moments, or a given
/// approach. Starts from `pressure`; stops
/// when the error, with gaps up to `rounding` [m] counted as closed, is below tol. Returns
/// converged = false after max_iterations.
Solution polonsky_keer(const operators::NormalDisplacement& displacement, const Field& initial_gap,
                       const RigidModes& modes, Field pressure, double tol, int max_iterations,
                       double rounding = 0.0);

}  // namespace samcontact::contact
