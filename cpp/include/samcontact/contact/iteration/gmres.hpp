// SPDX-License-Identifier: GPL-3.0-or-later
// Generalised minimal residual method (GMRES) for non-symmetric linear systems (Saad & Schultz
// 1986, doi:10.1137/0907058), with right preconditioning.
#pragma once

#include <functional>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// out = image of v under a linear map.
using LinearMap = std::function<void(const Field& v, Field& out)>;

/// Solves A x = b approximately: until the residual is below gain times |b|, or after max_steps
/// steps, each of which stores one vector. Starts from zero. The preconditioner must be linear too.
/// Returns the number of steps.
int gmres(const LinearMap& apply, const LinearMap& precondition, const Field& b, double gain,
          int max_steps, Field& x);

/// The same with a preconditioner that may differ from step to step (Saad 1993,
/// doi:10.1137/0914028): each step stores two vectors.
int flexible_gmres(const LinearMap& apply, const LinearMap& precondition, const Field& b,
                   double gain, int max_steps, Field& x);

}  // namespace samcontact::contact
