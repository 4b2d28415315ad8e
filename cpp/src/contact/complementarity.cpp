// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/complementarity.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

/// Rounding of the incrementally updated displacement is wiped out this often.
constexpr int refresh_interval = 30;

class ConjugateGradient {
 public:
  ConjugateGradient(const operators::SurfaceDisplacement& displacement, const Field& initial_gap,
                    double cell_area, Driver driver, Field pressure)
      : displacement_(displacement),
        initial_gap_(initial_gap),
        size_(initial_gap.size()),
        driver_(driver),
        load_driven_(driver.kind == Driver::Kind::load),
        target_sum_(driver.value / cell_area),
        p_(std::move(pressure)),
        u_(size_),
        g_(size_),
        t_(size_, 0.0),
        q_(size_) {
    if (load_driven_) scale_to_load();
    refresh();
  }

  Solution run(double tol, int max_iterations) {
    Solution solution;
    for (int n = 0;; ++n) {
      check_interrupt();
      update_gap();
      solution.error = error();
      if (solution.error <= tol && since_refresh_ > 0) {
        refresh();
        update_gap();
        solution.error = error();
      }
      solution.iterations = n;
      solution.converged = solution.error <= tol;
      if (solution.converged || n == max_iterations) break;
      advance();
    }
    solution.pressure = p_;
    solution.gap = g_;
    solution.approach = approach_;
    return solution;
  }

 private:
  void refresh() {
    displacement_.pressure(p_.data(), u_.data());
    since_refresh_ = 0;
  }

  double contact_mean(const Field& field) const {
    const double sum = ordered_sum(size_, [&](std::size_t i) { return p_[i] > 0 ? field[i] : 0; });
    const double cells = ordered_sum(size_, [&](std::size_t i) { return p_[i] > 0 ? 1.0 : 0.0; });
    return cells > 0 ? sum / cells : 0.0;
  }

  void update_gap() {
    for (std::size_t i = 0; i < size_; ++i) g_[i] = initial_gap_[i] + u_[i];
    approach_ = load_driven_ ? contact_mean(g_) : driver_.value;
    for (double& g : g_) g -= approach_;
  }

  double error() const {
    const double p_max = *std::max_element(p_.begin(), p_.end());
    const double u_max = *std::max_element(u_.begin(), u_.end());
    double largest = 0.0;
    if (p_max <= 0 || u_max <= 0) {
      // No pressure yet: any penetration counts in full.
      return *std::min_element(g_.begin(), g_.end()) < 0 ? 1.0 : 0.0;
    }
    for (std::size_t i = 0; i < size_; ++i) {
      largest = std::max(largest, std::fabs(std::min(p_[i] / p_max, g_[i] / u_max)));
    }
    return largest;
  }

  /// One projected conjugate-gradient step from the current gap.
  void advance() {
    const auto active = [&](std::size_t i) { return p_[i] > 0; };
    const double norm =
        ordered_sum(size_, [&](std::size_t i) { return active(i) ? g_[i] * g_[i] : 0.0; });
    const double beta = conjugate_ && norm_ > 0 ? norm / norm_ : 0.0;
    norm_ = norm;
    for (std::size_t i = 0; i < size_; ++i) t_[i] = active(i) ? g_[i] + beta * t_[i] : 0.0;

    displacement_.pressure(t_.data(), q_.data());
    const double shift = load_driven_ ? contact_mean(q_) : 0.0;
    const double gt = ordered_sum(size_, [&](std::size_t i) { return g_[i] * t_[i]; });
    const double qt = ordered_sum(size_, [&](std::size_t i) { return (q_[i] - shift) * t_[i]; });
    // Without an active cell with a residual there is no curvature: use the cell's own stiffness.
    const double step = qt > 0 ? gt / qt : 1.0 / displacement_.self_influence();

    bool clipped = false, released = false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (active(i)) {
        const double p = p_[i] - step * t_[i];
        clipped |= p <= 0;
        p_[i] = std::max(p, 0.0);
      } else if (g_[i] < 0) {
        released = true;
        p_[i] = -step * g_[i];
      }
    }
    conjugate_ = !released;
    const double scale = load_driven_ ? scale_to_load() : 1.0;
    if (clipped || released || ++since_refresh_ >= refresh_interval) {
      refresh();
    } else {
      for (std::size_t i = 0; i < size_; ++i) u_[i] = scale * (u_[i] - step * q_[i]);
    }
  }

  double scale_to_load() {
    const double sum = ordered_sum(size_, [&](std::size_t i) { return p_[i]; });
    const double scale = sum > 0 ? target_sum_ / sum : 0.0;
    if (sum > 0) {
      for (double& p : p_) p *= scale;
    } else {
      std::fill(p_.begin(), p_.end(), target_sum_ / size_);
    }
    return scale;
  }

  const operators::SurfaceDisplacement& displacement_;
  const Field& initial_gap_;
  std::size_t size_;
  Driver driver_;
  bool load_driven_;
  double target_sum_;
  Field p_, u_, g_, t_, q_;
  double approach_ = 0.0, norm_ = 0.0;
  bool conjugate_ = false;
  int since_refresh_ = 0;
};

}  // namespace

Solution solve_complementarity(const operators::SurfaceDisplacement& displacement,
                               const Field& initial_gap, double cell_area, Driver driver,
                               Field pressure, double tol, int max_iterations) {
  const double lowest = *std::min_element(initial_gap.begin(), initial_gap.end());
  const bool load_driven = driver.kind == Driver::Kind::load;
  Solution solution;
  if (load_driven ? driver.value == 0 : driver.value <= lowest) {
    // Apart, or just touching: nothing to solve.
    solution.approach = load_driven ? lowest : driver.value;
    solution.pressure.assign(initial_gap.size(), 0.0);
    solution.gap = initial_gap;
    for (double& g : solution.gap) g -= solution.approach;
    return solution;
  }
  ConjugateGradient iteration(displacement, initial_gap, cell_area, driver, std::move(pressure));
  solution = iteration.run(tol, max_iterations);
  solution.load =
      load_driven ? driver.value : cell_area * ordered_sum(initial_gap.size(), [&](std::size_t i) {
                                     return solution.pressure[i];
                                   });
  return solution;
}

}  // namespace samcontact::contact
