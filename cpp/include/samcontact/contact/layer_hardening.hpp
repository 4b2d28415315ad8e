// SPDX-License-Identifier: GPL-3.0-or-later
// Layer between the bodies whose shear strength changes with its plastic slip.
#pragma once

#include <functional>

#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

/// Iterates the plastic slip of the layer until the shear of each flowing cell is its strength. The
/// plastic slip before the increment is that of the conditions. Throws std::invalid_argument if
/// the layer softens so much that an increment may have several solutions; ConvergenceError if the
/// plastic slip does not converge.
PartialSlipSolution solve_with_hardening(const ThirdBody& law, const Grid& grid,
                                         const SolveUnder& solve, Field pressure,
                                         const PartialSlipStart& start,
                                         const FrictionConditions& given,
                                         const RateSettings& settings,
                                         const std::function<double(bool)>& self_influence);

}  // namespace samcontact::contact
