// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/joint/joint_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {
namespace {

/// A shear of at least this fraction of its bound is on it.
constexpr double on_bound = 1 - 1e-9;
/// Cells that stick initially if no tractions are known: one in this many, and the minimum number.
constexpr std::size_t initial_fraction = 8, min_initial_cells = 4;

double force_error(const JointProblem& problem, const JointState& state, double scale) {
  const std::size_t n = problem.size();
  double error = 0.0;
  if (problem.normal.is_force()) {
    const double sum = ordered_sum(n, [&](std::size_t i) { return state.tractions[i]; });
    error = std::fabs(sum - problem.normal.value) / problem.normal.value;
  }
  for (const JointProblem::Mode& mode : problem.tilts) {
    const double sum = ordered_dot(mode.direction.data(), state.tractions.data(), n);
    const double possible = ordered_sum(n, [&](std::size_t i) {
      return std::fabs(mode.direction[i]) * std::max(state.tractions[i], 0.0);
    });
    if (possible > 0) error = std::max(error, std::fabs(mode.target - sum) / possible);
  }
  for (const JointProblem::Mode& mode : problem.modes) {
    const double* shear = state.tractions.data() + n;
    const double sum = ordered_dot(mode.direction.data(), shear, 2 * n);
    const double possible = ordered_sum(2 * n, [&](std::size_t i) {
      const std::size_t cell = i < n ? i : i - n;
      if (state.states[cell] == JointCellState::open) return 0.0;
      const double bound = problem.cone.radius(state.tractions[cell], state.shear(cell));
      return std::fabs(mode.direction[i]) * std::min(bound, scale);
    });
    if (possible > 0) error = std::max(error, std::fabs(mode.target - sum) / possible);
  }
  return error;
}

/// Distance of the shear of a cell from its projection s + stiffness w onto its bound.
double shear_residual(const JointProblem& problem, const JointState& state, std::size_t i,
                      double gap_scale) {
  const std::size_t n = problem.size();
  const double p = state.tractions[i], shear = state.shear(i);
  if (!in_contact(p) && !(shear > 0)) return 0.0;
  const double radius = problem.cone.radius(p, shear);
  const double x = state.tractions[n + i] + problem.stiffness * state.slip[i],
               y = state.tractions[2 * n + i] + problem.stiffness * state.slip[n + i];
  const double pull = length_of(x, y), share = pull > radius ? radius / pull : 1.0;
  const double off =
      length_of(state.tractions[n + i] - share * x, state.tractions[2 * n + i] - share * y);
  // Shear at zero pressure requires contact.
  const double apart = in_contact(p) ? 0.0 : std::min(shear, std::fabs(state.gap[i]) * gap_scale);
  return std::max(off, apart);
}

void update_errors(const JointProblem& problem, JointState& state) {
  const std::size_t n = problem.size();
  const Field pressure(state.tractions.begin(), state.tractions.begin() + std::ssize(state.gap));
  state.pressure_error =
      complementarity_error(pressure, state.displacement, state.gap, problem.rounding);
  const double largest = largest_of(n, [&](std::size_t i) { return state.shear(i); });
  const double slip = largest_of(n, [&](std::size_t i) {
    return state.states[i] == JointCellState::open ? 0.0
                                                   : length_of(state.slip[i], state.slip[n + i]);
  });
  const double pressed = largest_of(n, [&](std::size_t i) { return pressure[i]; });
  const double present = std::max(largest, problem.stiffness * slip);
  const double bound = problem.cone.radius(pressed, largest);
  const double scale = std::max(std::min(bound, 10 * present), smallest_fraction * pressed);
  const double lifted =
      largest_of(n, [&](std::size_t i) { return std::fabs(state.displacement[i]); });
  const double gap_scale = lifted > 0 ? scale / lifted : 0.0;
  state.shear_error =
      scale > 0
          ? largest_of(
                n, [&](std::size_t i) { return shear_residual(problem, state, i, gap_scale); }) /
                scale
          : 0.0;
  state.shear_error = std::max(state.shear_error, force_error(problem, state, scale));
}

}  // namespace

void JointProblem::use(CircleCoordinates coordinates) {
  circle = std::move(coordinates);
  circle.apply(free_slip.data(), size());
  circle.apply(motion.data(), size());
  for (Mode& mode : modes) circle.apply(mode.direction.data(), size());
}

void JointProblem::displace(const Field& tractions, Field& displacement, ComplexField& work) const {
  const Field* acting = &tractions;
  if (circle.is_on()) {
    displacement = tractions;
    circle.apply(displacement.data() + size(), size());
    acting = &displacement;
  }
  operators->displacement.apply(acting->data(), displacement.data(), work);
  circle.apply(displacement.data() + size(), size());
}

void JointProblem::precondition(Field& displacement, ComplexField& work) const {
  circle.undo(displacement.data() + size(), size());
  operators->preconditioner.apply(displacement.data(), displacement.data(), work);
  circle.undo(displacement.data() + size(), size());
}

double JointState::shear(std::size_t i) const {
  const std::size_t n = states.size();
  return length_of(tractions[n + i], tractions[2 * n + i]);
}

double JointState::outward(std::size_t i) const {
  const std::size_t n = states.size();
  return direction[i] * slip[i] + direction[n + i] * slip[n + i];
}

JointState start_from(const JointProblem& problem, Field tractions) {
  const std::size_t n = problem.size();
  JointState state{std::move(tractions),
                   std::vector<JointCellState>(n, JointCellState::open),
                   Field(2 * n, 0.0),
                   0.0,
                   std::vector<double>(problem.tilts.size(), 0.0),
                   std::vector<double>(problem.modes.size(), 0.0)};
  std::fill_n(state.direction.begin(), n, 1.0);
  const FrictionCone& cone = problem.cone;
  bool touches = false;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = state.tractions[i], shear = state.shear(i);
    if (!in_contact(p) && !(cone.slope == 0 && shear > 0)) continue;
    touches = touches || in_contact(p);
    const bool bounded = shear > 0 && shear >= cone.radius(p, shear) * on_bound;
    state.states[i] = !bounded                       ? JointCellState::stick
                      : shear >= cone.cap * on_bound ? JointCellState::capped
                                                     : JointCellState::slide;
    if (!(shear > 0)) continue;
    state.direction[i] = state.tractions[n + i] / shear;
    state.direction[n + i] = state.tractions[2 * n + i] / shear;
  }
  if (!touches) {
    Field sorted = problem.gap;
    const std::size_t last = std::min(n - 1, std::max(min_initial_cells, n / initial_fraction));
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(last),
                     sorted.end());
    for (std::size_t i = 0; i < n; ++i) {
      const bool near = problem.gap[i] <= sorted[last] && std::isfinite(problem.gap[i]);
      state.states[i] = near ? JointCellState::stick : JointCellState::open;
    }
  }
  put_on_lines(cone, state);
  return state;
}

void put_on_lines(const FrictionCone& cone, JointState& state) {
  const std::size_t n = state.states.size();
  for_each_cell(n, [&](std::size_t i) {
    double& p = state.tractions[i];
    double &x = state.tractions[n + i], &y = state.tractions[2 * n + i];
    if (state.states[i] == JointCellState::open) p = x = y = 0.0;
    if (state.states[i] == JointCellState::slide) p = cone.slope * state.shear(i);
    if (state.states[i] == JointCellState::capped) {
      p = std::max(p, cone.slope * cone.cap);
      x = cone.cap * state.direction[i];
      y = cone.cap * state.direction[n + i];
    }
  });
}

void evaluate(const JointProblem& problem, JointState& state, ComplexField& work) {
  const std::size_t n = problem.size();
  state.displacement.resize(3 * n);
  problem.displace(state.tractions, state.displacement, work);
  state.gap.resize(n);
  state.slip = problem.free_slip;
  for_each_cell(n, [&](std::size_t i) {
    state.gap[i] = problem.gap[i] + state.displacement[i] - state.approach;
    state.slip[i] -= state.displacement[n + i];
    state.slip[n + i] -= state.displacement[2 * n + i];
  });
  for (std::size_t k = 0; k < problem.tilts.size(); ++k) {
    add_scaled(-state.tilt[k], problem.tilts[k].direction, state.gap);
  }
  add_scaled(1.0, problem.motion, state.slip);
  for (std::size_t k = 0; k < problem.modes.size(); ++k) {
    add_scaled(state.motion[k], problem.modes[k].direction, state.slip);
  }
  update_errors(problem, state);
}

}  // namespace samcontact::contact
