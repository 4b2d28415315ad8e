// SPDX-License-Identifier: GPL-3.0-or-later
// Frictionless contact with an attraction that depends on the gap: several states may be in
// equilibrium; the solver follows the branch of its start.
#pragma once

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/normal/adhesive_surface.hpp"
#include "samcontact/contact/normal/complementarity.hpp"

namespace samcontact::contact {

class AdhesiveContact {
 public:
  AdhesiveContact(const Grid& grid, const operators::SurfaceInfluence& influence,
                  SharedContactLaw law);

  /// Solution with tension as negative pressure, on the branch of the initial pressure; zero
  /// everywhere: from undeformed surfaces. An approach is reached in one descent of the energy; a
  /// load by a search for its approach, moments by a search for their tilts. Throws PullOffError
  /// and ConvergenceError.
  Solution solve(const Field& gap, const Drive& drive, const Field& initial_pressure, double tol,
                 int max_iterations) const;

 private:
  /// Solution with prescribed tilts.
  Solution solve_held(const Field& gap, const Drive& drive, const Field& initial_pressure,
                      double tol, int max_iterations) const;
  /// Tilts from which the search for moments starts: those of the initial pressure.
  AboutAxes first_tilts(const Field& gap, const Drive& drive, const Field& initial_pressure) const;
  /// Solution of a load, by one descent from the contact of a pressure; not converged if the
  /// contact is lost or many iterations do not suffice.
  Solution solve_under_load(const Field& gap, const Drive& drive, const Field& initial_pressure,
                            double tol) const;

  AdhesiveSurface surface_;
  SharedContactLaw law_;
};

}  // namespace samcontact::contact
