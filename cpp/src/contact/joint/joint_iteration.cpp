// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/joint/joint_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/joint/joint_step.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {
namespace {

/// Reduction of the residual by a linear solve.
constexpr double joint_gain = 1e-2;
/// Tractions and displacements below this fraction of the tolerance count as zero.
constexpr double negligible = 1e-2;

std::size_t hash_of(const std::vector<JointCellState>& states) {
  return std::hash<std::string_view>{}(
      {reinterpret_cast<const char*>(states.data()), states.size()});
}

}  // namespace

JointIteration::JointIteration(const JointProblem& problem, JointState state, double tol,
                               StateRule rule, JointWork& work)
    : problem_(problem),
      state_(std::move(state)),
      tol_(tol),
      rule_(rule),
      work_(work),
      departures_(problem.size(), 0) {}

void JointIteration::update() {
  evaluate(problem_, state_, scratch_);
  ++work_.applications;
  work_.operations += problem_.operators->displacement.cost();
}

bool JointIteration::run(int max_steps) {
  update();
  best_ = state_;
  for (int step = 0; step < max_steps; ++step) {
    check_interrupt();
    ++work_.steps;
    const int iterations = JointStep(problem_, state_, scratch_).take(joint_gain);
    work_.iterations += iterations;
    work_.applications += iterations;
    work_.operations += iterations * (problem_.operators->displacement.cost() +
                                      problem_.operators->preconditioner.cost());
    update();
    if (!(state_.error() < INFINITY)) return false;
    if (state_.error() < best_.error()) best_ = state_;
    if (state_.error() <= tol_) return true;
    change_states();
  }
  return false;
}

JointIteration::Zero JointIteration::zero() const {
  const std::size_t n = problem_.size();
  const double pressure = largest_of(n, [&](std::size_t i) { return state_.tractions[i]; });
  const double shear = largest_of(n, [&](std::size_t i) { return state_.shear(i); });
  const double length =
      largest_of(n, [&](std::size_t i) { return std::fabs(state_.displacement[i]); });
  const double part = negligible * tol_;
  return {part * pressure, part * length, part * std::max(shear, pressure)};
}

/// State of an overlapping cell, from the tractions that would close its gap and stop its slip in
/// the absence of other changes.
JointCellState JointIteration::after_opening(std::size_t i) {
  const auto& displacement = problem_.operators->displacement;
  const double pressure = -state_.gap[i] / displacement.normal_self_influence();
  const double slip = length_of(state_.slip[i], state_.slip[problem_.size() + i]);
  if (rule_.patience > 0) {
    const bool returns = departures_[i] >= rule_.patience && slip > 0;
    return returns ? JointCellState::slide : JointCellState::stick;
  }
  const double shear = slip / displacement.tangential_self_influence();
  const FrictionCone& cone = problem_.cone;
  if (shear * cone.slope <= pressure && shear <= cone.cap) return JointCellState::stick;
  return pressure > cone.slope * cone.cap ? JointCellState::capped : JointCellState::slide;
}

/// State of a sticking cell whose shear exceeds its bound.
JointCellState JointIteration::after_sticking(std::size_t i) {
  const FrictionCone& cone = problem_.cone;
  const double pressure = state_.tractions[i];
  const bool returns = rule_.patience > 0 && departures_[i] >= rule_.patience;
  ++departures_[i];
  if (in_contact(pressure) && pressure >= cone.slope * cone.cap) return JointCellState::capped;
  return in_contact(pressure) || returns ? JointCellState::slide : JointCellState::open;
}

JointCellState JointIteration::after_slipping(std::size_t i, const Zero& zero) const {
  const FrictionCone& cone = problem_.cone;
  const std::size_t n = problem_.size();
  const bool slides = state_.states[i] == JointCellState::slide;
  const double along = state_.direction[i] * state_.tractions[n + i] +
                       state_.direction[n + i] * state_.tractions[2 * n + i];
  if (slides && along < -zero.shear) return JointCellState::open;
  if (state_.outward(i) < -zero.length) return JointCellState::stick;
  if (slides) return along > cone.cap + zero.shear ? JointCellState::capped : JointCellState::slide;
  const bool leaves = state_.tractions[i] < cone.slope * cone.cap - zero.pressure;
  return leaves ? JointCellState::slide : JointCellState::capped;
}

JointCellState JointIteration::chosen(std::size_t i, const Zero& zero) {
  const FrictionCone& cone = problem_.cone;
  switch (state_.states[i]) {
    case JointCellState::open:
      return state_.gap[i] < -zero.length ? after_opening(i) : JointCellState::open;
    case JointCellState::stick: {
      const double shear = state_.shear(i);
      const bool beyond =
          state_.tractions[i] < cone.slope * shear - zero.pressure || shear > cone.cap + zero.shear;
      return beyond ? after_sticking(i) : JointCellState::stick;
    }
    default:
      return after_slipping(i, zero);
  }
}

/// Changes the state of a cell. A cell begins to slip along its shear, or along its slip if it has
/// no shear.
void JointIteration::enter(std::size_t i, JointCellState next) {
  const std::size_t n = problem_.size();
  const bool slipped = state_.states[i] >= JointCellState::slide;
  state_.states[i] = next;
  if (next < JointCellState::slide || slipped) return;
  const double shear = state_.shear(i), slip = length_of(state_.slip[i], state_.slip[n + i]);
  if (shear > 0) {
    state_.direction[i] = state_.tractions[n + i] / shear;
    state_.direction[n + i] = state_.tractions[2 * n + i] / shear;
  } else if (slip > 0) {
    state_.direction[i] = state_.slip[i] / slip;
    state_.direction[n + i] = state_.slip[n + i] / slip;
  }
}

void JointIteration::change_states() {
  const std::size_t n = problem_.size();
  const Zero small = zero();
  std::vector<JointCellState> next(n);
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < n; ++i) {
    next[i] = chosen(i, small);
    if (next[i] != state_.states[i]) changed.push_back(i);
  }
  if (changed.empty()) return;
  cycles_ = !seen_.insert(hash_of(next)).second || cycles_;
  // A random half of the changes ends a cycle.
  const std::size_t kept = cycles_ && changed.size() > 1 ? random_() % changed.size() : n;
  for (std::size_t k = 0; k < changed.size(); ++k) {
    const bool skipped = kept < n && k != kept && (random_() & 1U) != 0;
    if (!skipped) enter(changed[k], next[changed[k]]);
  }
  put_on_lines(problem_.cone, state_);
  const auto touches = [](JointCellState state) { return state != JointCellState::open; };
  if (std::none_of(state_.states.begin(), state_.states.end(), touches)) {
    const auto nearest = std::min_element(state_.gap.begin(), state_.gap.end());
    state_.states[nearest - state_.gap.begin()] = JointCellState::stick;
  }
  update();
}

}  // namespace samcontact::contact
