// SPDX-License-Identifier: GPL-3.0-or-later
// The frictionless contact problem on a grid: p >= 0, g = h + K p - delta >= 0, p g = 0.
#pragma once

#include <string>

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/surface_displacement.hpp"

namespace samcontact::contact {

/// What drives the contact: a total load [N] or an approach of the bodies [m].
struct Driver {
  enum class Kind { load, approach } kind;
  double value;

  static Driver load(double newton) { return {Kind::load, newton}; }
  static Driver approach(double metre) { return {Kind::approach, metre}; }
};

struct Solution {
  Field pressure;  // [i][j] [Pa]
  Field gap;       // [i][j] [m]
  double approach = 0.0;
  double load = 0.0;
  /// max over cells of |min(p / max p, g / max u)|: pressure where there is a gap, and gap or
  /// penetration where there is pressure, each relative to its own scale.
  double error = 0.0;
  int iterations = 0;
  bool converged = true;
  /// Which border the contact touches and the remedy; empty when it touches none.
  std::string border_complaint;
};

/// Conjugate gradient on the cells in contact with projection to p >= 0 (Polonsky & Keer 1999,
/// doi:10.1016/S0043-1648(99)00113-1), for a given load or approach. Starts from `pressure`; stops
/// when the error defined above is below tol. Returns converged = false after max_iterations.
Solution solve_complementarity(const operators::SurfaceDisplacement& displacement,
                               const Field& initial_gap, double cell_area, Driver driver,
                               Field pressure, double tol, int max_iterations);

}  // namespace samcontact::contact
