// SPDX-License-Identifier: GPL-3.0-or-later
// The generalised minimal residual method for linear systems that are not symmetric (Saad &
// Schultz 1986, doi:10.1137/0907058), preconditioned from the right.
#pragma once

#include <functional>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// out = what a linear map makes of v.
using LinearMap = std::function<void(const Field& v, Field& out)>;

/// x with A x = b nearly: until the residual is below gain times |b|, or after most_steps, each of
/// which keeps one vector. Starts from zero. The precondition must be linear too. Returns the
/// steps.
int gmres(const LinearMap& apply, const LinearMap& precondition, const Field& b, double gain,
          int most_steps, Field& x);

}  // namespace samcontact::contact
