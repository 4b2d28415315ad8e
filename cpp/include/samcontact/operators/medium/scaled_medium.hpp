// SPDX-License-Identifier: GPL-3.0-or-later
// Medium whose surface displacements are those of another medium times a factor: a viscoelastic
// body in one increment.
#pragma once

#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// The medium itself for a factor of 1. For displacements due to tractions, and for heat, which
/// does not depend on the moduli; stress and strain throw std::logic_error.
SharedMedium scaled_medium(const SharedMedium& medium, double compliance);

}  // namespace samcontact::operators
