// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and shear of an increment together, if the sweeps have stalled.
#include "samcontact/contact/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

/// (p, s_x, s_y) of a pressure and a shear, either of which may be empty.
Field joined(const Field& pressure, const Field& shear, std::size_t n) {
  Field tractions = pressure;
  tractions.resize(n, 0.0);
  tractions.insert(tractions.end(), shear.begin(), shear.end());
  tractions.resize(3 * n, 0.0);
  return tractions;
}

/// Factors of the bounds of the cells that leave some friction in each of them.
Field positive(Field factor) {
  for (double& value : factor) value = std::max(value, smallest_factor);
  return factor;
}

/// Lowering of body 1 due to a unit tilt about x (k = 0) or y [m].
Field lever_arms(const Grid& grid, int k) {
  RigidMotion turn;
  turn.tilt[k] = 1.0;
  const Lowering lowering(grid, turn);
  Field arms(grid.surface_size());
  for (std::size_t i = 0; i < arms.size(); ++i) arms[i] = lowering(i);
  return arms;
}

}  // namespace

Field PartialSlipContact::Sweeps::direction(int k) const {
  const Grid& grid = contact_.grid_;
  const std::vector<double> x = grid.x(), y = grid.y();
  Field slip(2 * n_, 0.0);
  for (std::size_t i = 0; i < n_; ++i) {
    if (k != 1) slip[i] = k == 0 ? 1.0 : -y[i % grid.ny];
    if (k != 0) slip[n_ + i] = k == 1 ? 1.0 : x[i / grid.ny];
  }
  return slip;
}

JointProblem PartialSlipContact::Sweeps::joint_problem() {
  const double cell = contact_.grid_.cell_area();
  const Given& normal = drive_.normal;
  JointProblem problem{.operators = &contact_.joint_.operators(),
                       .gap = gap_,
                       .normal = normal.is_force() ? Given::force(normal.value / cell) : normal,
                       .cone = FrictionCone(contact_.friction_),
                       .free_slip = before_.free_slip,
                       .motion = Field(2 * n_, 0.0),
                       .rounding = s_.normal.rounding};
  for (int k = 0; k < 2; ++k) {
    const Given& tilt = drive_.tilt[k];
    if (tilt.is_force()) {
      problem.tilts.push_back({lever_arms(contact_.grid_, k), tilt.value / cell});
    } else if (tilt.value != 0) {
      add_scaled(-tilt.value, lever_arms(contact_.grid_, k), problem.gap);
    }
  }
  problem.free_slip.resize(2 * n_, 0.0);
  const auto& displacement = problem.operators->displacement;
  Field u = joined(before_.pressure, before_.shear, n_);
  displacement.apply(u.data(), u.data(), work_);
  for (std::size_t i = 0; i < 2 * n_; ++i) problem.free_slip[i] += u[n_ + i];
  for (int k = 0; k < 3; ++k) {
    if (tangential_[k].is_force()) {
      problem.modes.push_back({direction(k), tangential_[k].value / cell});
    } else if (tangential_[k].value != 0) {
      add_scaled(tangential_[k].value, direction(k), problem.motion);
    }
  }
  const Field& p = s_.normal.tractions.pressure;
  const double largest = largest_of(n_, [&](std::size_t i) { return p[i]; });
  // Shear proportional to the pressure.
  u.assign(3 * n_, 0.0);
  for (std::size_t i = 0; i < n_; ++i) u[n_ + i] = largest > 0 ? p[i] / largest : 0.0;
  displacement.apply(u.data(), u.data(), work_);
  const double slid = longest(Field(u.begin() + static_cast<std::ptrdiff_t>(n_), u.end()));
  problem.stiffness = 1 / (slid > 0 ? slid : displacement.tangential_self_influence());
  problem.use({contact_.friction_.stretch(), positive(friction_.factor)});
  return problem;
}

JointState PartialSlipContact::Sweeps::joint_start(const JointProblem& problem,
                                                   const Field& pressure,
                                                   const Field& shear) const {
  Field tractions = joined(pressure, shear, n_);
  problem.circle.undo(tractions.data() + n_, n_);
  JointState state = start_from(problem, std::move(tractions));
  const Given& normal = drive_.normal;
  state.approach = normal.is_force() ? s_.normal.motion.approach : normal.value;
  std::size_t mode = 0;
  for (int k = 0; k < 2; ++k) {
    if (drive_.tilt[k].is_force()) state.tilt[mode++] = s_.normal.motion.tilt[k];
  }
  mode = 0;
  for (int k = 0; k < 3; ++k) {
    if (tangential_[k].is_force()) state.motion[mode++] = s_.tangential.motion[k];
  }
  return state;
}

void PartialSlipContact::Sweeps::solve_jointly() {
  const JointProblem problem = joint_problem();
  std::vector<JointState> starts;
  if (is_finite(s_.normal) && all_finite(s_.tangential.shear)) {
    starts.push_back(joint_start(problem, s_.normal.tractions.pressure, s_.tangential.shear));
  }
  starts.push_back(joint_start(problem, before_.pressure, before_.shear));
  const JointSolution found =
      JointSolver::solve(problem, starts, settings_.tol, settings_.max_iterations);
  s_.joint = found.work;
  s_.normal.iterations += found.work.iterations;
  s_.normal.operator_applications += found.work.applications;
  s_.normal.work += found.work.operations / contact_.normal_.displacement().cost();
  const double present = std::max(s_.normal.error, s_.tangential.error);
  if (found.converged || !(present <= found.state.error())) take(problem, found);
}

void PartialSlipContact::Sweeps::take(const JointProblem& problem, const JointSolution& found) {
  const JointState& state = found.state;
  const auto end = state.tractions.begin() + static_cast<std::ptrdiff_t>(n_);
  Solution& normal = s_.normal;
  normal.tractions.pressure.assign(state.tractions.begin(), end);
  normal.gap = state.gap;
  normal.motion.approach = state.approach;
  std::size_t mode = 0;
  for (int k = 0; k < 2; ++k) {
    const Given& tilt = drive_.tilt[k];
    normal.motion.tilt[k] = tilt.is_force() ? state.tilt[mode++] : tilt.value;
  }
  normal.moment = moments(contact_.grid_, normal.tractions.pressure);
  normal.load = contact_.grid_.cell_area() *
                ordered_sum(n_, [&](std::size_t i) { return state.tractions[i]; });
  if (drive_.normal.is_force() && found.converged) normal.load = drive_.normal.value;
  normal.error = state.pressure_error;
  normal.converged = found.converged;
  take_shear(problem, state);
  s_.tangential.converged = found.converged;
}

void PartialSlipContact::Sweeps::take_shear(const JointProblem& problem, const JointState& state) {
  ShearSolution& shear = s_.tangential;
  const auto end = state.tractions.begin() + static_cast<std::ptrdiff_t>(n_);
  shear.shear.assign(end, state.tractions.end());
  shear.slip.assign(2 * n_, 0.0);
  shear.sticking.assign(n_, 0);
  for (std::size_t i = 0; i < n_; ++i) {
    const bool sticks = state.states[i] == JointCellState::stick;
    shear.sticking[i] = sticks && in_contact(state.tractions[i]);
    if (sticks || state.states[i] == JointCellState::open) continue;
    shear.slip[i] = state.slip[i];
    shear.slip[n_ + i] = state.slip[n_ + i];
  }
  problem.circle.apply(shear.shear.data(), n_);
  problem.circle.undo(shear.slip.data(), n_);
  const double cell = contact_.grid_.cell_area();
  std::size_t mode = 0;
  for (int k = 0; k < 3; ++k) {
    shear.motion[k] = tangential_[k].is_force() ? state.motion[mode++] : tangential_[k].value;
  }
  shear.force = forces(contact_.grid_, shear.shear);
  shear.friction_work = cell * dot(shear.shear, shear.slip);
  shear.error = state.shear_error;
  const double power = ordered_sum(n_, [&](std::size_t i) {
    const JointCellState cell_state = state.states[i];
    const bool slips = cell_state >= JointCellState::slide;
    const double w = slips ? length_of(state.slip[i], state.slip[n_ + i]) : 0.0;
    return w > 0 ? problem.cone.radius(state.tractions[i], state.shear(i)) * w : 0.0;
  });
  shear.energy_gap = contact_.friction_.prevents_slip() ? std::numeric_limits<double>::quiet_NaN()
                                                        : cell * power - shear.friction_work;
}

}  // namespace samcontact::contact
