// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/slip_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {
namespace {

/// Number of outer steps without this relative reduction of the error before a fallback is used.
constexpr double progress = 0.7;
constexpr int max_stalled_slip_steps = 7;

}  // namespace

SlipIteration::SlipIteration(const ShearProblem& problem, ShearApplier& operators, ShearStart start,
                             double self_influence)
    : problem_(problem),
      operators_(operators),
      m_(problem.size()),
      self_influence_(self_influence),
      normal_(2 * m_, 0.0),
      lambda_(m_, 0.0) {
  r_.shear = std::move(start.shear);
  r_.shear.resize(2 * m_, 0.0);
  r_.slip.assign(2 * m_, 0.0);
  r_.slipping = std::move(start.slipping);
  r_.motion = std::move(start.motion);
  r_.motion.resize(problem.modes.size(), 0.0);
  cut_to_bound(problem.bound, r_.shear);
}

ShearResult SlipIteration::run(double tol, int max_steps) {
  double best = INFINITY, lowest = INFINITY;
  Field best_shear;
  std::vector<double> best_motion;
  for (int stalled_steps = 0;; ++r_.steps) {
    check_interrupt();
    evaluate();
    r_.converged = r_.error <= tol;
    if (r_.converged || r_.steps >= max_steps) break;
    if (r_.error < lowest) {
      lowest = r_.error;
      best_shear = r_.shear;
      best_motion = r_.motion;
    }
    stalled_steps = r_.error < progress * best ? 0 : stalled_steps + 1;
    best = stalled_steps == 0 ? r_.error : best;
    if (stalled_steps > max_stalled_slip_steps) {
      if (best_shear.empty()) break;  // no error was finite
      ++r_.fallbacks;
      // Continue from the best shear, not from the last one.
      r_.shear = best_shear;
      r_.motion = best_motion;
      fall_back(tol);
      stalled_steps = 0;
      best = INFINITY;
      continue;
    }
    // The first step starts from incorrect sets. If a later step gains little, so do the following
    // ones.
    gains_little_ = gains_little_ || (stalled_steps > 0 && r_.steps > 1);
    choose_sets();
    // Otherwise no step brings the forces closer to their prescribed values.
    if (!forces_follow()) stick_everywhere();
    step(tol);
  }
  finish();
  return std::move(r_);
}

bool SlipIteration::forces_follow() const {
  for (const ShearProblem::Mode& mode : problem_.modes) {
    Field free = mode.direction;
    project_free(free);
    if (!(dot(free, free) > decisive * dot(mode.direction, mode.direction))) return false;
  }
  return true;
}

void SlipIteration::stick_everywhere() {
  std::fill(r_.slipping.begin(), r_.slipping.end(), 0);
  std::fill(lambda_.begin(), lambda_.end(), 0.0);
}

void SlipIteration::take_slipping() {
  r_.slipping.resize(m_);
  for_each_cell(
      m_, [&](std::size_t i) { r_.slipping[i] = length(i) >= problem_.bound[i] * on_circle; });
}

void SlipIteration::put_on_circle(std::size_t i) {
  const double size = length(i), bound = problem_.bound[i];
  r_.slipping[i] = size > 0 && std::isfinite(bound);
  if (!is_slipping(i)) return;
  r_.shear[i] *= bound / size;
  r_.shear[m_ + i] *= bound / size;
}

void SlipIteration::slip_beyond_bound() {
  for_each_cell(m_, [&](std::size_t i) {
    if (is_slipping(i) || length(i) > problem_.bound[i]) put_on_circle(i);
  });
}

void SlipIteration::take_normals() {
  for_each_cell(m_, [&](std::size_t i) {
    const double size = length(i), over = size > 0 ? 1 / size : 0.0;
    normal_[i] = r_.shear[i] * over;
    normal_[m_ + i] = r_.shear[m_ + i] * over;
  });
}

void SlipIteration::change_sides(double rho) {
  for_each_cell(m_, [&](std::size_t i) {
    const double bound = problem_.bound[i];
    if (is_slipping(i)) {
      r_.slipping[i] = outward(i) >= 0;
    } else if (length(i) >= bound * on_circle) {
      r_.slipping[i] = pull(i, rho) > bound * (1 + 1e-12);
    }
    // Rotation of the direction adds stiffness: the second derivative along the circle.
    lambda_[i] = is_slipping(i) ? std::max(outward(i), 0.0) / bound : 0.0;
  });
}

void SlipIteration::project_free(Field& v) const {
  for_each_cell(m_, [&](std::size_t i) {
    if (!is_slipping(i)) return;
    const double along = normal_[i] * v[m_ + i] - normal_[m_ + i] * v[i];
    v[i] = -along * normal_[m_ + i];
    v[m_ + i] = along * normal_[i];
  });
}

void SlipIteration::apply(const Field& v, Field& out) {
  operators_.near(v, out);
  for_each_cell(m_, [&](std::size_t i) {
    out[i] += lambda_[i] * v[i];
    out[m_ + i] += lambda_[i] * v[m_ + i];
  });
  project_free(out);
}

/// Slip decides which cells slip: a cell on its bound may be inside by rounding, and no cell slips
/// against its shear.
void SlipIteration::finish() {
  const double inside = 1 - std::max(1e-6, 10 * r_.error);
  for_each_cell(m_, [&](std::size_t i) {
    const double bound = problem_.bound[i];
    r_.slipping[i] = pull(i, problem_.stiffness) > bound * on_circle &&
                     length(i) > bound * inside && outward(i) >= 0;
  });
}

}  // namespace samcontact::contact
