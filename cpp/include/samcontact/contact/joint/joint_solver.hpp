// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for pressure and shear together: the operators of a grid, and the starts and rules that
// are tried in turn.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/joint/joint_iteration.hpp"
#include "samcontact/contact/joint/joint_problem.hpp"

namespace samcontact::contact {

struct JointSolution {
  JointState state;  // of the smallest error, with admissible tractions
  JointWork work;
  bool converged = false;
};

/// Keeps the operators of the grid once they are needed. Thread-safe.
class JointSolver {
 public:
  JointSolver(const Grid& grid, operators::TangentialInfluence influence)
      : grid_(grid), influence_(std::move(influence)) {}
  JointSolver(JointSolver&& other) noexcept
      : grid_(other.grid_),
        influence_(std::move(other.influence_)),
        operators_(std::move(other.operators_)) {}

  /// Operators of the grid.
  const JointOperators& operators() const;
  /// Solves from each of the starting tractions [3][i][j] in turn; then from the last of them with
  /// friction that grows from 1. Returns converged = false if all fail.
  JointSolution solve(const JointProblem& problem, const std::vector<JointState>& starts,
                      double tol) const;

 private:
  Grid grid_;
  operators::TangentialInfluence influence_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const JointOperators> operators_;
};

}  // namespace samcontact::contact
