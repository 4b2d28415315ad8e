// SPDX-License-Identifier: GPL-3.0-or-later
// Tangential forces on a layer that hardens: they may exceed its strength before the increment.
#pragma once

#include <functional>

#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

/// Solution for a drive and a start.
using SolveDriven =
    std::function<PartialSlipSolution(const TangentialDrive&, const PartialSlipStart&)>;

/// Solves as given; if this fails for forces on a layer that hardens, finds the motions that cause
/// these forces (Broyden 1965, doi:10.1090/S0025-5718-1965-0198670-6). Throws the error of the
/// solution as given if there are no such motions.
PartialSlipSolution solve_pulled(const FrictionLaw& friction, const Grid& grid,
                                 const TangentialDrive& drive, const SolveDriven& solve,
                                 const PartialSlipStart& start, double tol);

}  // namespace samcontact::contact
