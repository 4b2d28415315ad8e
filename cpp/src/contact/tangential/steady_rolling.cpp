// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/steady_rolling.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/contact/iteration/gmres.hpp"
#include "samcontact/contact/tangential/partial_slip.hpp"
#include "samcontact/contact/tangential/slip_iteration.hpp"

namespace samcontact::contact {
namespace {

/// Error reduction of a linear solve, and the maximum number of vectors it stores.
constexpr double rolling_gain = 1e-2;
constexpr int max_linear_steps = 60;
/// Distance rolled, in contact lengths, with steps of 4, 2 and 1 cells.
constexpr double rolled_lengths = 1.0;
constexpr double transient_tol = 1e-4;
constexpr int transient_steps = 50;

class SteadyRolling : public SlipIteration {
 public:
  SteadyRolling(const ShearProblem& problem, ShearApplier& operators, ShearStart start)
      : SlipIteration(problem, operators, std::move(start),
                      problem.operators->displacement.self_influence() -
                          problem.operators->displacement.neighbour_influence()),
        ahead_(2 * problem.carried),
        modes_(static_cast<int>(problem.modes.size())) {
    if (r_.slipping.empty()) take_slipping();
    slip_beyond_bound();
  }

 private:
  void evaluate() override {
    operators_.displacement(r_.shear, r_.slip);
    for (std::size_t i = 0; i < 2 * m_; ++i) r_.slip[i] = problem_.free_slip[i] - r_.slip[i];
    for (int k = 0; k < modes_; ++k) add_scaled(r_.motion[k], mode(k).direction, r_.slip);
    take_normals();
    r_.error = natural_residual(problem_, r_.shear, r_.slip);
  }

  /// Uses half of the stiffness of a cell, so that fewer cells change sides and the sets settle.
  void choose_sets() override { change_sides(0.5 / self_influence_); }

  const ShearProblem::Mode& mode(int k) const { return problem_.modes[k]; }
  void step(double tol) override;
  Field solved(Field right);
  void meet_forces(Field& change);
  void precondition(const Field& r, Field& z);
  void sum_from_ahead(Field& v);
  void fall_back(double tol) override;
  void roll_by(int cells, int times);

  Field ahead_;
  const int modes_;
};

/// (1 - T)^-1, with zero displacement ahead of the contact.
void SteadyRolling::sum_from_ahead(Field& v) {
  const std::size_t width = problem_.carried;
  std::fill(ahead_.begin(), ahead_.end(), 0.0);
  for (std::size_t i = m_; i-- > 0;) {
    const std::size_t j = problem_.cells[i] % width;
    v[i] = ahead_[j] += v[i];
    v[m_ + i] = ahead_[width + j] += v[m_ + i];
  }
}

/// Sticking cells: inverse of each Fourier mode, then the sum from the leading edge, since (1 - T)
/// C is of order zero. Slipping cells: inverse of the diagonal.
void SteadyRolling::precondition(const Field& r, Field& z) {
  z = r;
  for (std::size_t i = 0; i < m_; ++i) {
    if (is_slipping(i)) z[i] = z[m_ + i] = 0.0;
  }
  operators_.precondition(z, z);
  sum_from_ahead(z);
  for (std::size_t i = 0; i < m_; ++i) {
    if (!is_slipping(i)) continue;
    z[i] = r[i] / (lambda_[i] + self_influence_);
    z[m_ + i] = r[m_ + i] / (lambda_[i] + self_influence_);
  }
  project_free(z);
}

void SteadyRolling::step(double) {
  Field change = solved(r_.slip);
  if (modes_ > 0) meet_forces(change);
  add_scaled(1.0, change, r_.shear);
  slip_beyond_bound();
}

/// Shear of the free cells for the given slip.
Field SteadyRolling::solved(Field right) {
  Field change;
  project_free(right);
  r_.iterations += gmres([&](const Field& v, Field& out) { apply(v, out); },
                         [&](const Field& v, Field& out) { precondition(v, out); }, right,
                         rolling_gain, max_linear_steps, change);
  return change;
}

/// Adds the change of shear due to the motions for which the forces have their prescribed values.
void SteadyRolling::meet_forces(Field& change) {
  std::vector<Field> shears;
  shears.reserve(modes_);
  Eigen::MatrixXd slopes(modes_, modes_);
  Eigen::VectorXd missing(modes_);
  for (int k = 0; k < modes_; ++k) shears.push_back(solved(mode(k).direction));
  for (int k = 0; k < modes_; ++k) {
    missing[k] = mode(k).missing(r_.shear) - dot(mode(k).arms(), change);
    for (int l = 0; l < modes_; ++l) slopes(k, l) = dot(mode(k).arms(), shears[l]);
  }
  const Eigen::VectorXd motion = slopes.colPivHouseholderQr().solve(missing);
  for (int k = 0; k < modes_; ++k) {
    r_.motion[k] += motion[k];
    add_scaled(motion[k], shears[k], change);
  }
}

void SteadyRolling::fall_back(double) {
  const std::size_t width = problem_.carried;
  const std::size_t rows = problem_.cells.back() / width - problem_.cells.front() / width + 1;
  for (const int cells : {4, 2, 1}) {
    roll_by(cells, static_cast<int>(rolled_lengths * static_cast<double>(rows) / cells) + 1);
  }
  take_slipping();
  slip_beyond_bound();
}

/// Increments of a rolling history until the solution is steady: each increment transports the
/// shear of the previous one.
void SteadyRolling::roll_by(int cells, int times) {
  ShearProblem increment = problem_, carrying = problem_;
  increment.carried = 0;
  increment.stiffness = problem_.stiffness / cells;
  for (ShearProblem::Mode& mode : increment.modes) {
    mode.direction = std::exchange(mode.own_arms, {});
    for (double& slip : mode.direction) slip *= cells;
    mode.target *= cells;
  }
  carrying.carried = cells * problem_.carried;
  ShearApplier own(increment), carrier(carrying);
  Field now(2 * m_), moved(2 * m_);
  for (int n = 0; n < times; ++n) {
    check_interrupt();
    own.displacement(r_.shear, now);
    carrier.displacement(r_.shear, moved);
    for (std::size_t i = 0; i < 2 * m_; ++i) {
      increment.free_slip[i] = cells * problem_.free_slip[i] + now[i] - moved[i];
    }
    Field before = r_.shear;
    ShearResult next = solve_partial_slip(increment, own, {std::move(r_.shear), {}, r_.motion},
                                          transient_tol, transient_steps);
    add_scaled(-1.0, next.shear, before);
    const bool is_steady =
        longest(before) <= transient_tol * shear_scale(problem_, next.shear, next.slip);
    r_.shear = std::move(next.shear);
    r_.motion = std::move(next.motion);
    if (is_steady) break;
  }
  operators_.count(own);
  operators_.count(carrier);
}

}  // namespace

ShearResult solve_steady_rolling(const ShearProblem& problem, ShearApplier& operators,
                                 ShearStart start, double tol, int max_steps) {
  ShearResult result = SteadyRolling(problem, operators, std::move(start)).run(tol, max_steps);
  result.energy_gap = std::numeric_limits<double>::quiet_NaN();
  return result;
}

}  // namespace samcontact::contact
