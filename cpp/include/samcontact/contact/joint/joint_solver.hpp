// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for pressure and shear together: the operators of a grid, and the initial states and rules
// that are tried in turn.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/joint/joint_iteration.hpp"
#include "samcontact/contact/joint/joint_problem.hpp"

namespace samcontact::contact {

struct JointSolution {
  JointState state;  // with the smallest error, and admissible tractions
  JointWork work;
  bool converged = false;
};

/// Creates the operators of the grid when they are first needed. Thread-safe.
class JointSolver {
 public:
  JointSolver(const Grid& grid, operators::TangentialInfluence influence)
      : grid_(grid), influence_(std::move(influence)) {}

  /// Operators of the grid.
  const JointOperators& operators() const;
  /// Solves from each of the initial states in turn; then from the last one, with friction that
  /// increases from 1. Takes at most max_steps Newton steps in total. Returns converged = false if
  /// no attempt converges.
  static JointSolution solve(const JointProblem& problem, const std::vector<JointState>& starts,
                             double tol, int max_steps);

 private:
  Grid grid_;
  operators::TangentialInfluence influence_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const JointOperators> operators_;
};

}  // namespace samcontact::contact
