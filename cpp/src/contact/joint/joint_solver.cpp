// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/joint/joint_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/memory.hpp"
#include "samcontact/contact/joint/joint_step.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Newton steps with trial tractions of the cells, and with cells that slip when they touch again.
constexpr int plain_steps = 25, patient_steps = 50;
constexpr int patience = 2;
/// Continuation in the friction: first slope of the cone, its factor, the slope below which the
/// slope of the problem follows, and the maximum number of reductions of the factor.
constexpr double first_slope = 1.0, slope_factor = 0.5, last_slope = 1e-4;
constexpr int max_shortenings = 8;
/// Memory per cell of the grid: spectra of operator and preconditioner, and states; 590 to 730
/// bytes were measured on 301 x 301 cells, to which the continuation adds 220 bytes of states.
constexpr double joint_bytes = 950;
/// Memory per cell in contact: vectors of GMRES.
constexpr double vector_bytes = 3.0 * sizeof(double) * (max_joint_vectors + 2);
constexpr const char* memory_use = "pressure and shear together";

double touching_cells(const JointState& state) {
  return static_cast<double>(std::count_if(state.states.begin(), state.states.end(),
                                           [](auto cell) { return cell != JointCellState::open; }));
}

/// Sequence of attempts, and the state with the smallest error.
class Search {
 public:
  Search(const JointProblem& problem, double tol, int max_steps)
      : problem_(problem), tol_(tol), max_steps_(max_steps) {}

  /// Iterates from a state, which is replaced by the last one. Returns whether it converges.
  bool run(const JointProblem& problem, JointState& state, StateRule rule, int steps) {
    const int left = max_steps_ - found_.work.steps;
    if (left <= 0) return false;
    JointIteration iteration(problem, std::move(state), tol_, rule, found_.work);
    const bool converged = iteration.run(std::min(steps, left));
    state = iteration.state();
    if (&problem == &problem_) keep(converged ? iteration.state() : iteration.best());
    return converged;
  }

  /// Solves for slopes that decrease to that of the problem, each from the previous solution.
  bool continue_to_slope(const JointState& state) {
    JointProblem easier = problem_;
    const double target = problem_.cone.slope;
    double slope = std::max(first_slope, target), factor = slope_factor, reached = 0.0;
    JointState good;
    for (int shortened = 0; shortened <= max_shortenings;) {
      const bool last = slope == target;
      easier.cone.slope = slope;
      JointState trial = reached > 0 ? good : state;
      put_on_lines(easier.cone, trial);
      const JointProblem& problem = last ? problem_ : easier;
      bool solved = run(problem, trial, {}, patient_steps);
      if (!solved && reached > 0) {
        trial = good;
        put_on_lines(easier.cone, trial);
        solved = run(problem, trial, {1}, patient_steps);
      }
      if (solved && last) return true;
      if (solved) {
        good = std::move(trial);
        reached = slope;
      } else {
        if (!(reached > 0)) return false;
        ++shortened;
        factor = std::sqrt(factor);
      }
      const double next = reached * factor;
      slope = next <= std::max(target, last_slope) ? target : next;
    }
    return false;
  }

  JointSolution take() { return std::move(found_); }
  void set_converged() { found_.converged = true; }

 private:
  void keep(const JointState& state) {
    const bool better = !(found_.state.error() <= state.error());
    if (found_.state.tractions.empty() || better) found_.state = state;
  }

  const JointProblem& problem_;
  const double tol_;
  const int max_steps_;
  JointSolution found_;
};

/// Removes tension, and shear beyond the bound, which are within the error.
void make_admissible(const JointProblem& problem, JointState& state) {
  const std::size_t n = problem.size();
  for (std::size_t i = 0; i < n; ++i) {
    double& p = state.tractions[i];
    p = in_contact(p) ? p : 0.0;
    const double shear = state.shear(i), radius = problem.cone.radius(p, shear);
    if (state.states[i] == JointCellState::open || !(shear > radius)) continue;
    state.tractions[n + i] *= radius / shear;
    state.tractions[2 * n + i] *= radius / shear;
  }
}

}  // namespace

const JointOperators& JointSolver::operators() const {
  const std::lock_guard lock(mutex_);
  if (!operators_) {
    require_memory(static_cast<double>(grid_.surface_size()) * joint_bytes, memory_use);
    operators_ = std::make_unique<const JointOperators>(grid_, influence_);
  }
  return *operators_;
}

JointSolution JointSolver::solve(const JointProblem& problem, const std::vector<JointState>& starts,
                                 double tol, int max_steps) {
  double touching = 0.0;
  for (const JointState& start : starts) touching = std::max(touching, touching_cells(start));
  require_memory(touching * vector_bytes, memory_use);
  Search search(problem, tol, max_steps);
  const auto solved = [&] {
    for (const JointState& start : starts) {
      JointState plain = start;
      if (search.run(problem, plain, {}, plain_steps)) return true;
      JointState patient = start;
      if (search.run(problem, patient, {patience}, patient_steps)) return true;
    }
    return search.continue_to_slope(starts.back());
  };
  if (solved()) search.set_converged();
  JointSolution solution = search.take();
  make_admissible(problem, solution.state);
  return solution;
}

}  // namespace samcontact::contact
