// SPDX-License-Identifier: GPL-3.0-or-later
// Partial slip in steady rolling towards +x, coupled from cell to cell: the slip is the change of
// displacement of the material that comes from the next cell ahead.
#pragma once

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// The slip per cell rolled is w = b - (1 - T) C s, where T u is the displacement of the next cell
/// ahead. It is not the gradient of any function, but the conditions in the stick zone and in the
/// slip zone are unchanged. The problem has `carried` equal to one row of cells; rows run along +x.
/// Semismooth Newton, including the motions of prescribed forces; if the error does not fall, the
/// contact is rolled by steps of 4, 2 and 1 cells until it is steady, for which the box of the
/// operators has `rolling_margin` rows of cells ahead. Returns converged = false after max_steps.
ShearResult solve_steady_rolling(const ShearProblem& problem, ShearApplier& operators,
                                 ShearStart start, double tol, int max_steps);

constexpr int rolling_margin = 4;

}  // namespace samcontact::contact
