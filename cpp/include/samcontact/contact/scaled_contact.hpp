// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bodies that are more compliant than those of a solver by one factor.
#pragma once

#include <memory>

#include "samcontact/contact/contact_solver.hpp"

namespace samcontact::contact {

/// With pressure times the factor as the unknown, it is the contact of the solver. For hard contact
/// with shear in proportion to the pressure, without heat.
struct ScaledContact {
  std::shared_ptr<const ContactSolver> solver;
  double compliance = 1.0;

  /// As ContactSolver::solve.
  Solution solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                 const ContactSettings& settings) const;
};

/// Drive with all forces multiplied by a factor.
Drive scaled(Drive drive, double factor);
/// Solution with pressures and forces divided by a factor.
Solution unscaled(Solution solution, double factor);

}  // namespace samcontact::contact
