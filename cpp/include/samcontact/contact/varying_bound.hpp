// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the shear that depend on a quantity of the solution, and their fixed point.
#pragma once

#include <string>

#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

/// Bound of each cell that depends on a quantity of the solution, such as the slip rate; fields are
/// [i][j].
class VaryingBound {
 public:
  virtual ~VaryingBound() = default;

  /// Quantity from which the iteration starts.
  virtual const Field& before() const = 0;
  /// Quantity that follows from a solution.
  virtual Field after(const PartialSlipSolution& solution) const = 0;
  /// Bound relative to that of the law, in [0, 1], for a quantity and a pressure.
  virtual Field factors(const Field& quantity, const Field& pressure) const = 0;
  /// Throws std::invalid_argument if the increment may have several solutions. first: the first
  /// solution of the iteration.
  virtual void require_single(const PartialSlipSolution& first) const = 0;
  /// Part of the change to `next` that a step makes in a cell, in (0, 1].
  virtual double step(double next, double pressure) const = 0;
  /// Stores the quantity in the solution.
  virtual void store(PartialSlipSolution& solution, Field quantity) const = 0;
  /// Start of the message that the iteration did not converge, and the remedy.
  virtual std::string quantity() const = 0;
  virtual std::string remedy() const = 0;
};

/// Iterates until the bound of each cell is that of its quantity. Throws ConvergenceError if it
/// does not converge.
PartialSlipSolution solve_with_bound(const VaryingBound& bound, const SolveUnder& solve,
                                     Field pressure, const PartialSlipStart& start,
                                     const FrictionConditions& given, double tol);

}  // namespace samcontact::contact
