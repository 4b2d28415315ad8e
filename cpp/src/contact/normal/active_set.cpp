// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/survey.hpp"
#include "samcontact/contact/normal/working_set.hpp"

namespace samcontact::contact {
namespace {

/// Steps on one working set continue until tension or interpenetration exceeds the residual by this
/// factor; a smaller factor changes the set more often, at the cost of one more application each
/// time.
constexpr double initial_patience = 3.0;
constexpr double patience_loss = 0.3;
constexpr int max_steps_per_set = 10;
/// After this number of steps without halving the residual, rounding errors dominate.
constexpr int max_stalled_steps = 20;
/// Cells are added to the set only if its last change dropped less than this fraction of them: if
/// many cells are dropped and added alternately, the iteration can cycle.
constexpr double calm_fraction = 0.01;
/// Maximum number of times that a change of pressure is halved for the sake of the moments.
constexpr int max_retreats = 30;

class ActiveSet {
 public:
  ActiveSet(const NearProblem& problem, Field pressure, Field displacement)
      : problem_(problem),
        n_(pressure.size()),
        load_driven_(problem.modes.normal().is_force()),
        tilts_(problem.modes.tilts()),
        p_(std::move(pressure)),
        r_(n_),
        z_(n_),
        t_(n_),
        rest_(std::move(displacement)),
        states_(n_) {
    add_gap();
  }

  ActiveSetResult run(bool trim, double tol, int max_iterations) {
    for (;; trim = false) {
      check_interrupt();
      if (tilts_) level(problem_.modes.slope(rest_, [this](std::size_t i) { return p_[i]; }));
      const Totals all = totals(p_, rest_, gap());
      watch_energy(all);
      const double hold = trim ? 1.0 / problem_.self_influence : 0.0;
      const Survey cells = survey(p_, rest_, approach_, hold, all, states_);
      if (cells.error <= tol || iterations_ >= max_iterations) break;
      if (choose_working_set(cells) == 0) break;
      const Field before = tilts_ ? p_ : Field{};
      const bool descends = minimise(tol, max_iterations);
      drop_tension(before);
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

  /// Rigid-body position: under load, the mean of gap and displacement.
  double position() const {
    return load_driven_ ? set_.sums(rest_, rest_).plain / set_.size() : approach_;
  }

  /// Updates approach and scales. If the last change of the set raised the energy, the set is
  /// changed more often from then on.
  void watch_energy(const Totals& all) {
    approach_ = problem_.modes.normal().value;
    if (load_driven_) approach_ = all.contacts > 0 ? all.rest_in_contact / all.contacts : 0.0;
    const double energy = all.energy - (load_driven_ ? 0.0 : approach_ * all.pressure);
    if (energy > energy_) patience_ *= patience_loss;
    energy_ = energy;
    take_scales(all);
  }

  /// Initial gap, less the plane of the tilt.
  const Field& gap() const { return tilts_ ? tilted_gap_ : problem_.gap; }

  /// Tilts body 1 further.
  void level(const AboutAxes& tilt) {
    problem_.modes.lower(tilt, rest_);
    for (int k = 0; k < 2; ++k) tilt_[k] += tilt[k];
    tilted_gap_ = problem_.gap;
    problem_.modes.lower(tilt_, tilted_gap_);
  }

  /// Stores the scales of pressure and displacement, which hardly change on one set.
  void take_scales(const Totals& all) {
    p_scale_ = all.largest_pressure;
    u_scale_ = all.largest_displacement;
  }

  /// Selects the cells with pressure and, once few cells drop, those with interpenetration. Returns
  /// their number.
  std::size_t choose_working_set(const Survey& cells) {
    const bool release = dropped_ <= calm_fraction * cells.working;
    for_each_cell(std::ssize(states_), [&](std::ptrdiff_t i) {
      states_[i] = states_[i] == working || (release && states_[i] != idle);
    });
    if (cells.dropped > 0 && cells.working + (release ? cells.penetrating : 0) > 0) trim_to_set();
    set_.assign(states_, true);
    others_.assign(states_, false);
    return set_.size();
  }

  /// Removes the pressure outside the set, unless the set cannot carry the moments.
  void trim_to_set() {
    const Field before = tilts_ ? p_ : Field{};
    for_each_cell(std::ssize(p_), [&](std::ptrdiff_t i) { p_[i] = states_[i] ? p_[i] : 0.0; });
    if (!problem_.modes.meet(p_)) {
      p_ = before;
      for_each_cell(std::ssize(p_), [&](std::ptrdiff_t i) { states_[i] |= in_contact(p_[i]); });
      return;
    }
    settle();
    take_scales(totals(p_, rest_, gap()));
  }

  /// Computes the displacement of a pressure that was changed directly.
  void settle() {
    apply(p_, rest_);
    add_gap();
    problem_.modes.lower(tilt_, rest_);
  }

  void add_gap() {
    for_each_cell(std::ssize(rest_), [&](std::ptrdiff_t i) { rest_[i] += problem_.gap[i]; });
  }

  /// r = gap on the working set, under load relative to its mean there.
  void update_residual(double lowest_p, double lowest_gap, double stand) {
    const double u_scale = u_scale_ > 0 ? u_scale_ : 1.0;
    residual_ = set_.subtract(rest_, stand, r_) / u_scale;
    violation_ = std::max(p_scale_ > 0 ? -lowest_p / p_scale_ : 0.0, -lowest_gap / u_scale);
  }

  /// Conjugate gradient on the working set, in which the pressure may become negative. Returns
  /// false if rounding errors leave no descent.
  bool minimise(double tol, int max_iterations) {
    for_each_cell(std::ssize(r_), [&](std::ptrdiff_t i) { r_[i] = t_[i] = 0.0; });
    if (tilts_) level(problem_.modes.slope(rest_, [this](std::size_t i) { return states_[i]; }));
    double stand = position();
    update_residual(set_.lowest(p_, 0.0), others_.lowest(rest_, stand), stand);
    double zr_old = 0.0, lowest_residual = residual_;
    int stalled_steps = 0;
    for (int step = 1;; ++step) {
      check_interrupt();
      ++iterations_;
      // z = P M r, where P projects on the working set and, under load control, on zero sum. The
      // sum of r over the set is zero, so that z r equals the product of M r and r.
      problem_.operators.preconditioner.apply(r_.data(), z_.data(), work_);
      ++preconditioner_count_;
      flatten(z_);
      const Sums zr = set_.sums(z_, r_);
      const double beta = step > 1 ? zr.product / zr_old : 0.0;
      zr_old = zr.product;
      set_.update_direction(beta, z_, load_driven_ ? zr.plain / set_.size() : 0.0, t_);
      apply(t_, z_);  // z is free until the next step
      const AboutAxes turn = flatten(z_);
      const Sums zt = set_.sums(z_, t_);
      const double curvature = zt.product;
      // A working set that is already solved has no descent: then only the set has to change.
      if (zr.product > 0 && curvature < 0) negative_curvature_ = true;
      if (!(zr.product > 0) || !(curvature > 0)) {
        return step == 1 && violation_ > 0 && zr.product == 0;
      }
      const double length = zr.product / curvature;
      const double lowest_p = set_.add(length, t_, p_, 0.0);
      set_.add(length, z_, rest_, 0.0);
      for (int k = 0; k < 2; ++k) tilt_[k] += length * turn[k];
      if (load_driven_) stand += length * zt.plain / set_.size();
      const double lowest_gap = others_.add(length, z_, rest_, stand);
      if (u_scale_ == 0) {  // the first pressure
        level({});
        take_scales(totals(p_, rest_, gap()));
      }
      update_residual(lowest_p, lowest_gap, stand);
      stalled_steps = residual_ < 0.5 * lowest_residual ? 0 : stalled_steps + 1;
      if (stalled_steps == 0) lowest_residual = residual_;
      const bool violated = violation_ > 0.5 * tol;
      if (residual_ < 0.5 * tol || iterations_ >= max_iterations ||
          (violated && (violation_ > patience_ * residual_ || step >= max_steps_per_set))) {
        return true;
      }
      if (stalled_steps == max_stalled_steps) return false;
    }
  }

  /// Removes from a field the plane that leaves no moments over the set; returns its tilt.
  AboutAxes flatten(Field& field) {
    if (!tilts_) return {};
    const AboutAxes tilt =
        problem_.modes.slope(field, [this](std::size_t i) { return states_[i]; });
    problem_.modes.lower(tilt, field);
    return tilt;
  }

  void drop_tension(const Field& before) {
    const Field solved = tilts_ ? p_ : Field{};
    clip_tension();
    if (dropped_ == 0) return;
    // Part of the way from the start of the set, whose cells can carry the moments.
    double share = 1.0;
    for (int n = 0; !problem_.modes.meet(p_); ++n) {
      share = n < max_retreats ? 0.5 * share : 0.0;
      for_each_cell(std::ssize(p_), [&](std::ptrdiff_t i) {
        p_[i] = std::max(before[i] + share * (solved[i] - before[i]), 0.0);
      });
      if (share == 0) break;
    }
    settle();
  }

  void clip_tension() {
    dropped_ = 0;
    const std::ptrdiff_t n = std::ssize(p_);
#pragma omp parallel for schedule(static) reduction(+ : dropped_) if (n >= min_parallel_cells)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      dropped_ += p_[i] < 0;
      p_[i] = std::max(p_[i], 0.0);
    }
  }

  const NearProblem& problem_;
  const std::size_t n_;
  const bool load_driven_, tilts_;
  Field p_, r_, z_, t_;
  Field rest_;        // gap + displacement - plane of the tilt: the gap except for the approach
  Field tilted_gap_;  // of the last level(); empty without free tilts
  AboutAxes tilt_{};
  std::vector<unsigned char> states_;  // of CellState
  CellRuns set_, others_;
  ComplexField work_;
  double approach_ = 0.0, energy_ = INFINITY, patience_ = initial_patience;
  double p_scale_ = 0.0, u_scale_ = 0.0, residual_ = 0.0, violation_ = 0.0;
  std::size_t dropped_ = 0;
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
