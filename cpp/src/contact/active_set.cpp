// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {
namespace {

/// Steps on one working set go on until tension or penetration outweighs the residual this often;
/// less patience changes the set more often, each time for the price of one more application.
constexpr double initial_patience = 3.0;
constexpr double patience_loss = 0.3;
constexpr int most_steps_on_a_set = 10;
/// So many steps that do not halve the residual have met rounding.
constexpr int most_steps_in_vain = 20;
/// Cells are released only when the last change dropped a smaller share: releasing while many drop
/// can cycle.
constexpr double calm_share = 0.01;

class ActiveSet {
 public:
  ActiveSet(const NearProblem& problem, Field pressure, Field displacement)
      : problem_(problem),
        n_(pressure.size()),
        load_driven_(problem.driver.is_load()),
        p_(std::move(pressure)),
        u_(std::move(displacement)),
        g_(n_),
        r_(n_),
        z_(n_),
        t_(n_),
        working_(n_) {}

  ActiveSetResult run(bool trim, double tol, int max_iterations) {
    for (;; trim = false) {
      check_interrupt();
      approach_ = close_gap(problem_.gap, u_, p_, problem_.driver, g_);
      watch_energy();
      if (complementarity_error(p_, u_, g_) <= tol || iterations_ >= max_iterations) break;
      if (choose_working_set(trim) == 0) break;
      const bool descends = minimise(tol, max_iterations);
      drop_tension();
      if (!descends) break;
    }
    ActiveSetResult result;
    result.pressure = std::move(p_);
    result.iterations = iterations_;
    result.negative_curvature = negative_curvature_;
    result.operations = operator_count_ * problem_.operators.displacement.cost() +
                        preconditioner_count_ * problem_.operators.preconditioner.cost();
    return result;
  }

 private:
  void apply(const Field& pressure, Field& displacement) {
    problem_.operators.displacement.apply(pressure.data(), displacement.data(), work_);
    ++operator_count_;
  }

  template <class Change>
  void for_each_cell(const Change& change) {
    const std::ptrdiff_t n = n_;
#pragma omp parallel for schedule(static) if (n >= worth_threads_cells)
    for (std::ptrdiff_t i = 0; i < n; ++i) change(i);
  }

  /// A change of the set that raised the energy was premature.
  void watch_energy() {
    const double delta = load_driven_ ? 0.0 : approach_;
    const double energy = ordered_sum(
        n_, [&](std::size_t i) { return p_[i] * (0.5 * u_[i] + problem_.gap[i] - delta); });
    if (energy > energy_) patience_ *= patience_loss;
    energy_ = energy;
  }

  /// Cells with pressure and, once few cells drop, those with penetration. Returns their number.
  std::size_t choose_working_set(bool trim) {
    const double hold = trim ? 1.0 / problem_.self_influence : 0.0;
    std::size_t kept = 0, trimmed = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      working_[i] = p_[i] > 0 && p_[i] > hold * g_[i];
      kept += working_[i];
      trimmed += p_[i] > 0 && !working_[i];
    }
    std::size_t released = 0;
    if (dropped_ <= calm_share * kept) {
      for (std::size_t i = 0; i < n_; ++i) {
        if (working_[i] || p_[i] > 0 || g_[i] >= 0) continue;
        working_[i] = true;
        ++released;
      }
    }
    if (trimmed > 0 && kept + released > 0) {
      for (std::size_t i = 0; i < n_; ++i) p_[i] = working_[i] ? p_[i] : 0.0;
      settle();
    }
    size_ = kept + released;
    return size_;
  }

  /// Displacement of a pressure that was changed by hand, scaled to the load.
  void settle() {
    if (load_driven_) scale_to_sum(p_, problem_.driver.value / problem_.cell_area);
    apply(p_, u_);
  }

  /// r = gap on the working set, under load relative to its mean there.
  void update_residual() {
    double shift = approach_;
    if (load_driven_) {
      shift = ordered_sum(
                  n_, [&](std::size_t i) { return working_[i] ? problem_.gap[i] + u_[i] : 0.0; }) /
              size_;
    }
    double residual = 0.0, lowest_gap = 0.0, lowest_p = 0.0, highest_p = 0.0, highest_u = 0.0;
    const std::ptrdiff_t n = n_;
#pragma omp parallel for schedule(static) reduction(max : residual, highest_p, highest_u) \
    reduction(min : lowest_gap, lowest_p) if (n >= worth_threads_cells)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const double g = problem_.gap[i] + u_[i] - shift;
      r_[i] = working_[i] ? g : 0.0;
      residual = std::max(residual, std::fabs(r_[i]));
      if (!working_[i]) lowest_gap = std::min(lowest_gap, g);
      lowest_p = std::min(lowest_p, p_[i]);
      highest_p = std::max(highest_p, p_[i]);
      highest_u = std::max(highest_u, std::fabs(u_[i]));
    }
    const double u_scale = highest_u > 0 ? highest_u : 1.0;
    residual_ = residual / u_scale;
    violation_ = std::max(highest_p > 0 ? -lowest_p / highest_p : 0.0, -lowest_gap / u_scale);
  }

  /// z = P M r with P the projection on the working set and, under load, on zero sum; returns z r.
  double precondition() {
    problem_.operators.preconditioner.apply(r_.data(), z_.data(), work_);
    ++preconditioner_count_;
    double mean = 0.0;
    if (load_driven_) {
      mean = ordered_sum(n_, [&](std::size_t i) { return working_[i] ? z_[i] : 0.0; }) / size_;
    }
    return ordered_sum(n_, [&](std::size_t i) {
      z_[i] = working_[i] ? z_[i] - mean : 0.0;
      return z_[i] * r_[i];
    });
  }

  /// Conjugate gradient on the working set, where the pressure may become negative. False when
  /// rounding leaves no descent.
  bool minimise(double tol, int max_iterations) {
    update_residual();
    double zr_old = 0.0, lowest_residual = residual_;
    int in_vain = 0;
    for (int step = 1;; ++step) {
      check_interrupt();
      ++iterations_;
      const double zr = precondition();
      const double beta = step > 1 ? zr / zr_old : 0.0;
      zr_old = zr;
      for_each_cell([&](std::size_t i) { t_[i] = beta * t_[i] - z_[i]; });
      apply(t_, z_);  // z is free until the next step
      const double curvature = ordered_sum(n_, [&](std::size_t i) { return t_[i] * z_[i]; });
      // A working set that is already solved has no descent: then only the set has to change.
      if (zr > 0 && curvature < 0) negative_curvature_ = true;
      if (!(zr > 0) || !(curvature > 0)) return step == 1 && violation_ > 0 && zr == 0;
      const double length = zr / curvature;
      for_each_cell([&](std::size_t i) {
        p_[i] += length * t_[i];
        u_[i] += length * z_[i];
      });
      update_residual();
      in_vain = residual_ < 0.5 * lowest_residual ? 0 : in_vain + 1;
      if (in_vain == 0) lowest_residual = residual_;
      const bool violated = violation_ > 0.5 * tol;
      if (residual_ < 0.5 * tol || iterations_ >= max_iterations ||
          (violated && (violation_ > patience_ * residual_ || step >= most_steps_on_a_set))) {
        return true;
      }
      if (in_vain == most_steps_in_vain) return false;
    }
  }

  void drop_tension() {
    dropped_ = 0;
    for (double& p : p_) {
      dropped_ += p < 0;
      p = std::max(p, 0.0);
    }
    if (dropped_ > 0) settle();
  }

  const NearProblem& problem_;
  const std::size_t n_;
  const bool load_driven_;
  Field p_, u_, g_, r_, z_, t_;
  std::vector<unsigned char> working_;
  ComplexField work_;
  double approach_ = 0.0, energy_ = INFINITY, patience_ = initial_patience;
  double residual_ = 0.0, violation_ = 0.0;
  std::size_t size_ = 0, dropped_ = 0;
  bool negative_curvature_ = false;
  int iterations_ = 0, operator_count_ = 0, preconditioner_count_ = 0;
};

}  // namespace

ActiveSetResult solve_active_set(const NearProblem& problem, Field pressure, Field displacement,
                                 bool trim, double tol, int max_iterations) {
  return ActiveSet(problem, std::move(pressure), std::move(displacement))
      .run(trim, tol, max_iterations);
}

}  // namespace samcontact::contact
