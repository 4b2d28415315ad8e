// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/scaled_contact.hpp"

namespace samcontact::contact {

Drive scaled(Drive drive, double factor) {
  for (Given* given : {&drive.normal, drive.tilt.data(), &drive.tilt[1]}) {
    if (given->is_force()) given->value *= factor;
  }
  return drive;
}

Solution unscaled(Solution solution, double factor) {
  auto& [pressure, shear_x, shear_y] = solution.tractions;
  for (Field* field : {&pressure, &shear_x, &shear_y}) {
    for (double& traction : *field) traction /= factor;
  }
  solution.load /= factor;
  for (double& moment : solution.moment) moment /= factor;
  return solution;
}

Solution ScaledContact::solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                              const ContactSettings& settings) const {
  if (compliance == 1.0) return solver->solve(gap, drive, initial_pressure, settings);
  Field start = initial_pressure;
  for (double& p : start) p *= compliance;
  return unscaled(solver->solve(gap, scaled(drive, compliance), start, settings), compliance);
}

}  // namespace samcontact::contact
