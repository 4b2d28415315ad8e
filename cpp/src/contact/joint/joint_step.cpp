// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/joint/joint_step.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/iteration/gmres.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {
namespace {

/// Minimum slope of the friction cone in the preconditioner: for smaller slopes the pressure of a
/// cell is a poor measure of its shear.
constexpr double min_slope = 0.3;
/// Minimum shear of a slipping cell relative to the maximum traction.
constexpr double min_shear = 1e-12;
/// Maximum rotation of the shear of a slipping cell in a step [rad]; minimum ratio of the shears
/// after and before the step that is assumed for the rotation.
constexpr double max_turn = 0.7, min_length_ratio = 0.3;

}  // namespace

JointStep::JointStep(const JointProblem& problem, JointState& state, ComplexField& work)
    : problem_(problem),
      state_(state),
      work_(work),
      n_(problem.size()),
      line_(1 / std::max(1.0, problem.cone.slope)),
      normal_(problem.operators->displacement.normal_self_influence()),
      tangential_(problem.operators->displacement.tangential_self_influence()),
      box_(3 * n_) {
  find_cells();
  add_constraints();
}

void JointStep::find_cells() {
  const double largest =
      largest_of(3 * n_, [&](std::size_t i) { return std::fabs(state_.tractions[i]); });
  for (std::size_t i = 0; i < n_; ++i) {
    if (state_.states[i] == JointCellState::open) continue;
    cells_.push_back(i);
    double length = 0.0, lambda = 0.0;
    if (slips(i)) {
      const double along = state_.direction[i] * state_.tractions[n_ + i] +
                           state_.direction[n_ + i] * state_.tractions[2 * n_ + i];
      length = std::max({along, min_shear * largest, 1e-300});
      lambda = std::max(state_.outward(i), 0.0) / length;
    }
    length_.push_back(length);
    lambda_.push_back(lambda);
  }
}

void JointStep::add_constraint(const Field& direction, double missing) {
  Constraint made{{}, {}, 0.0, 0.0, missing};
  reduce(direction, made.residual);
  gather(direction, made.force);
  const auto normalise = [](Field& v) {
    const double length = std::sqrt(dot(v, v));
    if (length > 0) {
      for (double& value : v) value /= length;
    }
    return length;
  };
  made.residual_length = normalise(made.residual);
  made.force_length = normalise(made.force);
  if (made.force_length > 0) made.missing /= made.force_length;
  constraints_.push_back(std::move(made));
}

void JointStep::add_constraints() {
  Field direction(3 * n_, 0.0);
  const auto add = [&](double target) {
    add_constraint(direction, target - dot(direction, state_.tractions));
  };
  if (problem_.normal.is_force()) {
    std::fill_n(direction.begin(), n_, 1.0);
    add(problem_.normal.value);
    std::fill_n(direction.begin(), n_, 0.0);
  }
  for (const JointProblem::Mode& mode : problem_.tilts) {
    std::copy(mode.direction.begin(), mode.direction.end(), direction.begin());
    add(mode.target);
    std::fill_n(direction.begin(), n_, 0.0);
  }
  for (const JointProblem::Mode& mode : problem_.modes) {
    std::copy(mode.direction.begin(), mode.direction.end(),
              direction.begin() + static_cast<std::ptrdiff_t>(n_));
    add(mode.target);
  }
  const auto count = static_cast<Eigen::Index>(constraints_.size());
  if (count == 0) return;
  Eigen::MatrixXd schur(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    solved_.emplace_back();
    precondition_cells(constraints_[k].residual, solved_.back());
    for (Eigen::Index l = 0; l < count; ++l) schur(l, k) = dot(constraints_[l].force, solved_[k]);
  }
  schur_ = schur.completeOrthogonalDecomposition().pseudoInverse();
}

void JointStep::expand(const Field& v, Field& tractions) const {
  const double *a = slot(v, 0), *b = slot(v, 1), *c = slot(v, 2);
  for_each_cell(3 * n_, [&](std::size_t i) { tractions[i] = 0.0; });
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    const std::size_t i = cells_[k];
    double &p = tractions[i], &x = tractions[n_ + i], &y = tractions[2 * n_ + i];
    if (slips(i)) {
      const double nx = state_.direction[i], ny = state_.direction[n_ + i];
      p = pressed(i) * a[k];
      x = sheared(i) * a[k] * nx - b[k] * ny;
      y = sheared(i) * a[k] * ny + b[k] * nx;
    } else {
      p = a[k];
      x = b[k];
      y = c[k];
    }
  });
}

void JointStep::reduce(const Field& displacement, Field& v) const {
  v.resize(3 * cells_.size());
  double *a = slot(v, 0), *b = slot(v, 1), *c = slot(v, 2);
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    const std::size_t i = cells_[k];
    const double x = displacement[n_ + i], y = displacement[2 * n_ + i];
    a[k] = displacement[i];
    b[k] = slips(i) ? state_.direction[i] * y - state_.direction[n_ + i] * x : x;
    c[k] = slips(i) ? 0.0 : y;
  });
}

void JointStep::gather(const Field& tractions, Field& v) const {
  reduce(tractions, v);
  double* a = slot(v, 0);
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    const std::size_t i = cells_[k];
    if (!slips(i)) return;
    const double along =
        state_.direction[i] * tractions[n_ + i] + state_.direction[n_ + i] * tractions[2 * n_ + i];
    a[k] = pressed(i) * tractions[i] + sheared(i) * along;
  });
}

Field JointStep::right_side() const {
  Field residual(3 * n_), right;
  for_each_cell(n_, [&](std::size_t i) {
    residual[i] = std::isfinite(state_.gap[i]) ? -state_.gap[i] : 0.0;
    residual[n_ + i] = state_.slip[i];
    residual[2 * n_ + i] = state_.slip[n_ + i];
  });
  reduce(residual, right);
  for (double& value : right) value /= normal_;
  for (const Constraint& constraint : constraints_) right.push_back(constraint.missing);
  return right;
}

void JointStep::apply(const Field& v, Field& out) {
  expand(v, box_);
  problem_.displace(box_, box_, work_);
  reduce(box_, out);
  const std::size_t m = cells_.size();
  double* b = slot(out, 1);
  for_each_cell(std::ssize(cells_), [&](std::size_t k) { b[k] += lambda_[k] * v[m + k]; });
  for_each_cell(std::ssize(out), [&](std::size_t i) { out[i] /= normal_; });
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Field& residual = constraints_[k].residual;
    const double motion = v[3 * m + k];
    for_each_cell(std::ssize(residual), [&](std::size_t i) { out[i] -= motion * residual[i]; });
  }
  for (const Constraint& constraint : constraints_) {
    out.push_back(ordered_dot(constraint.force.data(), v.data(), 3 * m));
  }
}

/// Sticking cells: inverse of each Fourier mode. Slipping cells: pressure and rotation of that
/// inverse, the rotation reduced by its own stiffness.
void JointStep::precondition_cells(const Field& v, Field& out) {
  const double *a = slot(v, 0), *b = slot(v, 1), *c = slot(v, 2);
  for_each_cell(3 * n_, [&](std::size_t i) { box_[i] = 0.0; });
  const auto softened = [&](std::size_t k) { return tangential_ / (tangential_ + lambda_[k]); };
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    const std::size_t i = cells_[k];
    const double across = softened(k) * b[k];
    box_[i] = a[k] * normal_;
    box_[n_ + i] = normal_ * (slips(i) ? -across * state_.direction[n_ + i] : b[k]);
    box_[2 * n_ + i] = normal_ * (slips(i) ? across * state_.direction[i] : c[k]);
  });
  problem_.precondition(box_, work_);
  reduce(box_, out);
  double *p = slot(out, 0), *t = slot(out, 1);
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    if (!slips(cells_[k])) return;
    if (state_.states[cells_[k]] == JointCellState::slide) {
      p[k] /= std::max(problem_.cone.slope, min_slope) * line_;
    }
    t[k] *= softened(k);
  });
}

void JointStep::precondition(const Field& v, Field& out) {
  precondition_cells(v, out);
  const auto count = static_cast<Eigen::Index>(constraints_.size());
  const std::size_t m = 3 * cells_.size();
  Eigen::VectorXd missing(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    missing[k] = v[m + k] - dot(constraints_[k].force, out);
  }
  if (count == 0) return;
  const Eigen::VectorXd motion = schur_ * missing;
  for (Eigen::Index k = 0; k < count; ++k) add_scaled(motion[k], solved_[k], out);
  out.insert(out.end(), motion.begin(), motion.end());
}

int JointStep::take(double gain) {
  Field change;
  const int steps = gmres([&](const Field& v, Field& out) { apply(v, out); },
                          [&](const Field& v, Field& out) { precondition(v, out); }, right_side(),
                          gain, max_joint_vectors, change);
  update(change);
  return steps;
}

void JointStep::turn(std::size_t k, double along, double across) {
  const std::size_t i = cells_[k];
  const bool slides = state_.states[i] == JointCellState::slide;
  const double length = slides ? length_[k] + along : problem_.cone.cap;
  const double angle = std::clamp(
      across / std::max(std::fabs(length), min_length_ratio * length_[k]), -max_turn, max_turn);
  const double x = state_.direction[i], y = state_.direction[n_ + i];
  state_.direction[i] = std::cos(angle) * x - std::sin(angle) * y;
  state_.direction[n_ + i] = std::cos(angle) * y + std::sin(angle) * x;
  state_.tractions[n_ + i] = length * state_.direction[i];
  state_.tractions[2 * n_ + i] = length * state_.direction[n_ + i];
  if (slides) state_.tractions[i] = problem_.cone.slope * length;
}

void JointStep::update(const Field& change) {
  const double *a = slot(change, 0), *b = slot(change, 1), *c = slot(change, 2);
  const std::size_t m = cells_.size();
  for_each_cell(std::ssize(cells_), [&](std::size_t k) {
    const std::size_t i = cells_[k];
    if (slips(i)) {
      if (state_.states[i] == JointCellState::capped) state_.tractions[i] += a[k];
      turn(k, sheared(i) * a[k], b[k]);
    } else {
      state_.tractions[i] += a[k];
      state_.tractions[n_ + i] += b[k];
      state_.tractions[2 * n_ + i] += c[k];
    }
  });
  std::size_t at = 3 * m;
  for (std::size_t k = 0; k < constraints_.size(); ++k, ++at) {
    const double length = constraints_[k].residual_length;
    const double moved = length > 0 ? change[at] * normal_ / length : 0.0;
    const std::size_t tilt = problem_.normal.is_force() ? 1 : 0;
    const std::size_t motion = tilt + problem_.tilts.size();
    (k < tilt     ? state_.approach
     : k < motion ? state_.tilt[k - tilt]
                  : state_.motion[k - motion]) += moved;
  }
}

}  // namespace samcontact::contact
