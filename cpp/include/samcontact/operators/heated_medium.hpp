// SPDX-License-Identifier: GPL-3.0-or-later
// A medium whose volume also feels the heat that a pressure brings: what pressure does to it is
// what pressure and heat do.
#pragma once

#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

/// heating: of a source at rest. Knows the volume only; the medium itself without heat.
SharedMedium heated(const SharedMedium& medium, const Heating& heating);

}  // namespace samcontact::operators
