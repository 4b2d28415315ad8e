// SPDX-License-Identifier: GPL-3.0-or-later
// The inner iteration of contact: preconditioned conjugate gradient on a working set of cells that
// changes by many cells at a time.
#pragma once

#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/preconditioner.hpp"

namespace samcontact::contact {

/// A contact problem on a box, with a cheap operator.
struct NearProblem {
  const NearOperators& operators;
  Field gap;  // initial gap of the box, with what the cheap operator misses [m]
  Given normal;
  double cell_area;
  double self_influence;  // u of a cell under its own unit pressure [m/Pa]
};

struct ActiveSetResult {
  Field pressure;
  int iterations = 0;
  bool negative_curvature = false;  // ended by it: the operator is indefinite on the working set
  double operations = 0.0;          // of the transforms, in the unit of fft::filter_cost
};

/// Lowers the complementarity error, as seen by the cheap operator, below tol. `displacement` is
/// that of the start `pressure`. trim: a rough start, which first loses the cells whose gap exceeds
/// what their own pressure makes. May end before tol, after max_iterations or when rounding leaves
/// no descent: the caller judges the result.
ActiveSetResult solve_active_set(const NearProblem& problem, Field pressure, Field displacement,
                                 bool trim, double tol, int max_iterations);

}  // namespace samcontact::contact
