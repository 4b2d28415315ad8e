// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/projected_gradient.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

constexpr int power_steps = 8;
/// Factor of the result of the power iteration, which ends below the largest eigenvalue.
constexpr double eigenvalue_safety = 1.2;
constexpr int max_projection_steps = 60, max_lengths = 60;
/// A step length is accepted if this fraction of the power of the forces remains, on either side.
constexpr double too_short = 0.5, too_long = 0.1;
constexpr double projection_tol = 1e-14;
/// Relative to the total force that the bounds permit: bounds the error of the present multipliers
/// if all cells are at their bound.
constexpr double regularisation = 1e-12;

using Vector = Eigen::VectorXd;

Field moved_by(const ShearProblem& problem, const Vector& c, Field v) {
  for (int k = 0; k < c.size(); ++k) add_motion(problem, k, c[k], v);
  return v;
}

/// v + sum of c_k direction_k, cut at the bounds, and the missing forces.
struct Trial {
  Field shear;
  Vector missing;
};

Trial trial_of(const ShearProblem& problem, const Field& v, const Vector& c) {
  Trial trial{moved_by(problem, c, v), Vector(c.size())};
  cut_to_bound(problem.bound, trial.shear);
  for (int k = 0; k < c.size(); ++k) {
    trial.missing[k] = problem.modes[k].missing(trial.shear);
  }
  return trial;
}

/// Derivative of the forces with respect to the multipliers: cut cells only rotate.
Eigen::MatrixXd stiffness_of(const ShearProblem& problem, const Field& v, const Vector& c) {
  const int count = static_cast<int>(c.size());
  const std::size_t m = problem.size();
  const Field raw = moved_by(problem, c, v);
  std::vector<Field> moved(count, Field(2 * m, 0.0));
  for (int k = 0; k < count; ++k) add_motion(problem, k, 1.0, moved[k]);
  Eigen::MatrixXd matrix(count, count);
  for (int k = 0; k < count; ++k) {
    for (int l = 0; l < count; ++l) {
      const Field &a = problem.modes[k].direction, &b = moved[l];
      matrix(k, l) = ordered_sum(m, [&](std::size_t i) {
        const double x = raw[i], y = raw[m + i], length = length_of(x, y);
        const double product = a[i] * b[i] + a[m + i] * b[m + i];
        if (!(length > problem.bound[i])) return product;
        const double along = (a[i] * x + a[m + i] * y) * (b[i] * x + b[m + i] * y);
        return problem.bound[i] / length * (product - along / (length * length));
      });
    }
  }
  for (int k = 0; k < count; ++k) {
    const Field& direction = problem.modes[k].direction;
    matrix(k, k) += regularisation * dot(direction, direction);
  }
  return matrix;
}

double largest_eigenvalue(const ShearProblem& problem, ShearApplier& operators) {
  const std::size_t m = problem.size();
  Field v(2 * m, 0.0), u(2 * m);
  for (std::size_t i = 0; i < m; ++i) v[i] = 1.0;
  double value = 0.0;
  for (int n = 0; n < power_steps; ++n) {
    const double size = std::sqrt(dot(v, v));
    for (double& x : v) x /= size;
    operators.displacement(v, u);
    value = dot(v, u);
    std::swap(u, v);
  }
  return eigenvalue_safety * value;
}

double longest_motion(const ShearProblem& problem, const Vector& c) {
  return std::max(longest(moved_by(problem, c, Field(2 * problem.size(), 0.0))), 1e-300);
}

/// Step that takes every cell across its bound: the only available scale if all cells are cut.
double across(const ShearProblem& problem, const Field& v, const Vector& c) {
  return 2 * (longest(moved_by(problem, c, v)) +
              *std::max_element(problem.bound.begin(), problem.bound.end()));
}

/// Advances along a step until the missing forces have almost no component along it: the slope of a
/// convex function only increases. False if there is no such point.
bool advance(const ShearProblem& problem, const Field& v, const Vector& step, Vector& c,
             Trial& trial) {
  const double first = trial.missing.dot(step);
  if (!(first > 0)) return false;
  double shortest = 0.0, furthest = INFINITY, length = 1.0;
  for (int n = 0; n < max_lengths; ++n) {
    Trial next = trial_of(problem, v, c + length * step);
    const double left = next.missing.dot(step);
    if (left <= too_short * first && left >= -too_long * first) {
      c += length * step;
      trial = std::move(next);
      return true;
    }
    (left > 0 ? shortest : furthest) = length;
    length = std::isinf(furthest) ? 4 * length : 0.5 * (shortest + furthest);
  }
  return false;
}

}  // namespace

bool project(const ShearProblem& problem, Field& v, std::vector<double>& multipliers) {
  const int count = static_cast<int>(problem.modes.size());
  Vector c = Vector::Zero(count), possible(count);
  for (int k = 0; k < count; ++k) {
    c[k] = multipliers[k];
    const Field& direction = problem.modes[k].direction;
    possible[k] = std::sqrt(dot(direction, direction)) * longest(direction);
  }
  Trial trial = trial_of(problem, v, c);
  const auto scaled = [&](const Vector& missing) {
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
      sum = std::max(sum, std::fabs(missing[k]) / (std::fabs(problem.modes[k].target) +
                                                   problem.smallest_shear * possible[k]));
    }
    return sum;
  };
  for (int n = 0; n < max_projection_steps && scaled(trial.missing) > projection_tol; ++n) {
    Vector step = stiffness_of(problem, v, c).fullPivLu().solve(trial.missing);
    step *= std::min(1.0, across(problem, v, c) / longest_motion(problem, step));
    if (!advance(problem, v, step, c, trial))
      break;  // rounding, or forces above the friction limit
  }
  for (int k = 0; k < count; ++k) multipliers[k] = c[k];
  v = std::move(trial.shear);
  return scaled(trial.missing) < 1e-9;
}

void projected_gradient(const ShearProblem& problem, ShearApplier& operators, double tol,
                        int max_steps, ShearResult& result) {
  const std::size_t m = problem.size();
  const double step = 1 / largest_eigenvalue(problem, operators);
  Field at = result.shear, u(2 * m);
  std::vector<double> multipliers(problem.modes.size());
  for (std::size_t k = 0; k < multipliers.size(); ++k) multipliers[k] = step * result.motion[k];
  double momentum = 1.0;
  for (int n = 0; n < max_steps; ++n) {
    check_interrupt();
    operators.displacement(at, u);
    Field next = at;
    for (std::size_t i = 0; i < 2 * m; ++i) next[i] += step * (problem.free_slip[i] - u[i]);
    project(problem, next, multipliers);
    // The momentum ends if the step has a component backwards.
    double rotated = 0.0;
    for (std::size_t i = 0; i < 2 * m; ++i) {
      rotated += (at[i] - next[i]) * (next[i] - result.shear[i]);
    }
    if (rotated > 0) momentum = 1.0;
    const double grown = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
    const double share = rotated > 0 ? 0.0 : (momentum - 1) / grown;
    for (std::size_t i = 0; i < 2 * m; ++i) at[i] = next[i] + share * (next[i] - result.shear[i]);
    result.shear = std::move(next);
    momentum = grown;
    if (n % 10 != 9 && n + 1 < max_steps) continue;
    operators.displacement(result.shear, u);
    for (std::size_t i = 0; i < 2 * m; ++i) result.slip[i] = problem.free_slip[i] - u[i];
    for (std::size_t k = 0; k < multipliers.size(); ++k) {
      result.motion[k] = multipliers[k] / step;
      add_motion(problem, k, result.motion[k], result.slip);
    }
    if (natural_residual(problem, result.shear, result.slip) < tol) return;
  }
}

}  // namespace samcontact::contact
