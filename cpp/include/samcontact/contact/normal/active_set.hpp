// SPDX-License-Identifier: GPL-3.0-or-later
// Inner iteration of the normal contact: preconditioned conjugate gradient on a working set of
// cells, which changes by many cells at a time.
#pragma once

#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/preconditioner.hpp"
#include "samcontact/contact/normal/rigid_modes.hpp"

namespace samcontact::contact {

/// Contact problem on a box with an approximate operator.
struct NearProblem {
  const NearOperators& operators;
  Field gap;  // initial gap of the box, corrected for the error of the approximate operator [m]
  RigidModes modes;       // over the box
  double self_influence;  // displacement of a cell under a unit pressure on it [m/Pa]
};

struct ActiveSetResult {
  Field pressure;
  int iterations = 0;
  bool negative_curvature =
      false;  // whether the iteration ended because the operator is indefinite on the working set
  double operations = 0.0;  // operations of the transforms, in units of fft::filter_cost
};

/// Reduces the complementarity error, evaluated with the approximate operator, below tol.
/// `displacement` must be the displacement due to the initial `pressure`. trim: for a rough start,
/// first removes the cells whose gap exceeds the displacement due to their own pressure. The
/// iteration may end before tol is reached, after max_iterations or if rounding prevents any
/// further descent: the caller checks the result.
ActiveSetResult solve_active_set(const NearProblem& problem, Field pressure, Field displacement,
                                 bool trim, double tol, int max_iterations);

}  // namespace samcontact::contact
