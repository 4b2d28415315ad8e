// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/steady_rolling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/contact/gmres.hpp"
#include "samcontact/contact/stick_slip.hpp"

namespace samcontact::contact {
namespace {

/// A shear of this share of its bound is on it.
constexpr double on_circle = 1 - 1e-9;
/// What a linear solve gains, and the vectors that it keeps at most.
constexpr double linear_gain = 1e-2;
constexpr int most_linear_steps = 60;
/// Outer steps that do not take this share off the error, before the contact is rolled.
constexpr double progress = 0.7;
constexpr int steps_in_vain = 7;
/// Of contact lengths, at steps of 4, 2 and 1 cells.
constexpr double rolled_lengths = 1.0;
constexpr double marching_tol = 1e-4;
constexpr int marching_steps = 50;

class SteadyRolling {
 public:
  SteadyRolling(const ShearProblem& problem, ShearApplier& operators, ShearStart start)
      : problem_(problem),
        operators_(operators),
        m_(problem.size()),
        normal_(2 * m_, 0.0),
        lambda_(m_, 0.0),
        ahead_(2 * problem.carried),
        self_influence_(problem.operators->displacement.self_influence() -
                        problem.operators->displacement.neighbour_influence()) {
    r_.shear = std::move(start.shear);
    r_.shear.resize(2 * m_, 0.0);
    r_.slip.assign(2 * m_, 0.0);
    r_.slipping = std::move(start.slipping);
    cut_to_bound(problem.bound, r_.shear);
    if (r_.slipping.empty()) take_slipping();
    put_on_circles();
  }

  ShearResult run(double tol, int most_steps) {
    double best = INFINITY;
    for (int in_vain = 0;; ++r_.steps) {
      check_interrupt();
      evaluate();
      r_.converged = r_.error <= tol;
      if (r_.converged || r_.steps >= most_steps) break;
      in_vain = r_.error < progress * best ? 0 : in_vain + 1;
      best = in_vain == 0 ? r_.error : best;
      if (in_vain > steps_in_vain) {
        roll();
        in_vain = 0;
        best = INFINITY;
        continue;
      }
      choose_sets();
      step();
    }
    finish();
    return std::move(r_);
  }

 private:
  double length(std::size_t i) const { return std::hypot(r_.shear[i], r_.shear[m_ + i]); }
  bool is_slipping(std::size_t i) const { return r_.slipping[i] != 0; }

  void take_slipping() {
    r_.slipping.resize(m_);
    for (std::size_t i = 0; i < m_; ++i) {
      r_.slipping[i] = length(i) >= problem_.bound[i] * on_circle;
    }
  }

  /// Slipping cells, and those beyond their bound, which slip then.
  void put_on_circles() {
    for (std::size_t i = 0; i < m_; ++i) {
      const double size = length(i), bound = problem_.bound[i];
      if (!is_slipping(i) && !(size > bound)) continue;
      r_.slipping[i] = size > 0 && std::isfinite(bound);
      if (!is_slipping(i)) continue;
      r_.shear[i] *= bound / size;
      r_.shear[m_ + i] *= bound / size;
    }
  }

  void evaluate() {
    operators_.displacement(r_.shear, r_.slip);
    for (std::size_t i = 0; i < 2 * m_; ++i) r_.slip[i] = problem_.free_slip[i] - r_.slip[i];
    for (std::size_t i = 0; i < m_; ++i) {
      const double over = length(i) > 0 ? 1 / length(i) : 0.0;
      normal_[i] = r_.shear[i] * over;
      normal_[m_ + i] = r_.shear[m_ + i] * over;
    }
    r_.error = natural_residual(problem_, r_.shear, r_.slip);
  }

  double outward(std::size_t i) const {
    return normal_[i] * r_.slip[i] + normal_[m_ + i] * r_.slip[m_ + i];
  }

  void choose_sets() {
    // Half of the stiffness of a cell: sets that change less settle.
    const double rho = 0.5 / self_influence_;
    for (std::size_t i = 0; i < m_; ++i) {
      const double bound = problem_.bound[i];
      if (is_slipping(i)) {
        r_.slipping[i] = outward(i) >= 0;
      } else if (length(i) >= bound * on_circle) {
        r_.slipping[i] = std::hypot(r_.shear[i] + rho * r_.slip[i],
                                    r_.shear[m_ + i] + rho * r_.slip[m_ + i]) > bound;
      }
      lambda_[i] = is_slipping(i) ? std::max(outward(i), 0.0) / bound : 0.0;
    }
  }

  /// Leaves slipping cells their tangent.
  void project_free(Field& v) const {
    for (std::size_t i = 0; i < m_; ++i) {
      if (!is_slipping(i)) continue;
      const double along = normal_[i] * v[m_ + i] - normal_[m_ + i] * v[i];
      v[i] = -along * normal_[m_ + i];
      v[m_ + i] = along * normal_[i];
    }
  }

  void step();
  void precondition(const Field& r, Field& z);
  void sum_from_ahead(Field& v);
  void roll();
  void roll_by(int cells, int times);
  void finish();

  const ShearProblem& problem_;
  ShearApplier& operators_;
  const std::size_t m_;
  ShearResult r_;
  Field normal_, lambda_, ahead_;
  double self_influence_;  // of one cell on what it slips
};

/// (1 - T)^-1, nothing being displaced ahead of the contact.
void SteadyRolling::sum_from_ahead(Field& v) {
  const std::size_t width = problem_.carried;
  std::fill(ahead_.begin(), ahead_.end(), 0.0);
  for (std::size_t i = m_; i-- > 0;) {
    const std::size_t j = problem_.cells[i] % width;
    v[i] = ahead_[j] += v[i];
    v[m_ + i] = ahead_[width + j] += v[m_ + i];
  }
}

/// Sticking cells: the inverse of each wave, then the sum from the leading edge, since (1 - T) C is
/// of order zero. Slipping ones: their diagonal.
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

void SteadyRolling::step() {
  Field residual = r_.slip, change;
  project_free(residual);
  const auto apply = [&](const Field& v, Field& out) {
    operators_.near(v, out);
    for (std::size_t i = 0; i < m_; ++i) {
      out[i] += lambda_[i] * v[i];
      out[m_ + i] += lambda_[i] * v[m_ + i];
    }
    project_free(out);
  };
  r_.iterations += gmres(
      apply, [&](const Field& v, Field& out) { precondition(v, out); }, residual, linear_gain,
      most_linear_steps, change);
  add_scaled(1.0, change, r_.shear);
  put_on_circles();
}

void SteadyRolling::roll() {
  ++r_.fallbacks;
  const std::size_t width = problem_.carried;
  const std::size_t rows = problem_.cells.back() / width - problem_.cells.front() / width + 1;
  for (const int cells : {4, 2, 1}) {
    roll_by(cells, static_cast<int>(rolled_lengths * static_cast<double>(rows) / cells) + 1);
  }
  take_slipping();
  put_on_circles();
}

/// Increments of a history: what an increment leaves is carried, and is slip or shear of the next.
void SteadyRolling::roll_by(int cells, int times) {
  ShearProblem increment = problem_, carrying = problem_;
  increment.carried = 0;
  increment.stiffness = problem_.stiffness / cells;
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
    r_.shear =
        solve_stick_slip(increment, own, {r_.shear, {}, {}}, marching_tol, marching_steps).shear;
  }
  operators_.count(own);
  operators_.count(carrier);
}

/// Which cells slip is judged by the slip: one on its bound may be a rounding inside.
void SteadyRolling::finish() {
  const double inside = 1 - std::max(1e-6, 10 * r_.error), rho = problem_.stiffness;
  for (std::size_t i = 0; i < m_; ++i) {
    const double bound = problem_.bound[i];
    r_.slipping[i] = std::hypot(r_.shear[i] + rho * r_.slip[i],
                                r_.shear[m_ + i] + rho * r_.slip[m_ + i]) > bound * on_circle &&
                     length(i) > bound * inside;
  }
  r_.energy_gap = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ShearResult solve_steady_rolling(const ShearProblem& problem, ShearApplier& operators,
                                 ShearStart start, double tol, int most_steps) {
  return SteadyRolling(problem, operators, std::move(start)).run(tol, most_steps);
}

}  // namespace samcontact::contact
