// SPDX-License-Identifier: GPL-3.0-or-later
// Newton iteration on pressure and shear together: steps with fixed cell states, and changes of
// the states between them.
#pragma once

#include <cstddef>
#include <random>
#include <unordered_set>

#include "samcontact/contact/joint/joint_problem.hpp"

namespace samcontact::contact {

/// Work of a joint solution.
struct JointWork {
  int steps = 0;            // Newton steps
  int iterations = 0;       // GMRES steps
  int applications = 0;     // of the exact operator
  double operations = 0.0;  // in units of fft::filter_cost
};

/// Choice of the new state of cells that neither stick nor remain open.
struct StateRule {
  /// Number of releases under tension after which a cell slips when it touches again; 0: its trial
  /// tractions decide.
  int patience = 0;
};

class JointIteration {
 public:
  /// Iterates from a state; adds its work to `work`.
  JointIteration(const JointProblem& problem, JointState state, double tol, StateRule rule,
                 JointWork& work);

  /// Takes at most max_steps Newton steps, until the error is within the tolerance. Returns whether
  /// it is.
  bool run(int max_steps);

  /// Present state, and state with the smallest error so far.
  const JointState& state() const { return state_; }
  const JointState& best() const { return best_; }

 private:
  /// Values below which pressure, length and shear count as zero: maxima of pressure, displacement
  /// and shear, times a fraction of the tolerance.
  struct Zero {
    double pressure, length, shear;
  };
  void update();
  Zero zero() const;
  JointCellState chosen(std::size_t i, const Zero& zero);
  JointCellState after_opening(std::size_t i);
  JointCellState after_sticking(std::size_t i);
  JointCellState after_slipping(std::size_t i, const Zero& zero) const;
  void change_states();
  void enter(std::size_t i, JointCellState next);

  const JointProblem& problem_;
  JointState state_, best_;
  const double tol_;
  const StateRule rule_;
  JointWork& work_;
  ComplexField scratch_;
  std::vector<int> departures_;           // releases of each cell under tension
  std::unordered_set<std::size_t> seen_;  // hashes of sets of states
  bool cycles_ = false;
  // One seed for all runs, so that results are reproducible.
  // NOLINTNEXTLINE(bugprone-random-generator-seed)
  std::mt19937 random_{std::mt19937::default_seed};
};

}  // namespace samcontact::contact
