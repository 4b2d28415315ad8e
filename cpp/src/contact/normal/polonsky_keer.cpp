// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/polonsky_keer.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Number of steps after which the incrementally updated displacement is computed again, to remove
/// rounding errors.
constexpr int refresh_interval = 30;

class ConjugateGradient {
 public:
  ConjugateGradient(const operators::NormalDisplacement& displacement, const Field& initial_gap,
                    double cell_area, Given normal, Field pressure)
      : displacement_(displacement),
        initial_gap_(initial_gap),
        size_(initial_gap.size()),
        normal_(normal),
        target_sum_(normal.value / cell_area),
        p_(std::move(pressure)),
        u_(size_),
        g_(size_),
        t_(size_, 0.0),
        q_(size_) {
    if (normal_.is_force()) scale_to_sum(p_, target_sum_);
    refresh();
  }

  Solution run(double tol, int max_iterations, double rounding) {
    Solution solution;
    solution.rounding = rounding;
    for (int n = 0;; ++n) {
      check_interrupt();
      update_gap();
      solution.error = complementarity_error(p_, u_, g_, rounding);
      if (solution.error <= tol && since_refresh_ > 0) {
        refresh();
        update_gap();
        solution.error = complementarity_error(p_, u_, g_, rounding);
      }
      solution.iterations = n;
      solution.converged = solution.error <= tol;
      if (solution.converged || n == max_iterations) break;
      advance();
    }
    solution.tractions.pressure = p_;
    solution.negative_curvatures = negative_curvatures_;
    solution.gap = g_;
    solution.motion.approach = approach_;
    solution.operator_applications = applications_;
    solution.work = applications_;
    return solution;
  }

 private:
  void apply(const Field& pressure, Field& displacement) {
    displacement_.apply(pressure.data(), displacement.data(), work_);
    ++applications_;
  }

  void refresh() {
    apply(p_, u_);
    since_refresh_ = 0;
  }

  void update_gap() { approach_ = close_gap(initial_gap_, u_, p_, normal_, g_); }

  /// One projected conjugate-gradient step from the current gap.
  void advance() {
    const auto active = [&](std::size_t i) { return in_contact(p_[i]); };
    const double norm =
        ordered_sum(size_, [&](std::size_t i) { return active(i) ? g_[i] * g_[i] : 0.0; });
    const double beta = conjugate_ && norm_ > 0 ? norm / norm_ : 0.0;
    norm_ = norm;
    for (std::size_t i = 0; i < size_; ++i) t_[i] = active(i) ? g_[i] + beta * t_[i] : 0.0;

    apply(t_, q_);
    const double shift = normal_.is_force() ? contact_mean(p_, q_) : 0.0;
    const double gt = ordered_sum(size_, [&](std::size_t i) { return g_[i] * t_[i]; });
    const double qt = ordered_sum(size_, [&](std::size_t i) { return (q_[i] - shift) * t_[i]; });
    // Without an active cell with a residual there is no curvature: use the stiffness of the cell
    // itself.
    negative_curvatures_ += qt < 0;
    const double step = qt > 0 ? gt / qt : 1.0 / displacement_.self_influence();

    bool clipped = false, released = false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (active(i)) {
        const double p = p_[i] - step * t_[i];
        clipped |= !in_contact(p);
        p_[i] = std::max(p, 0.0);
      } else if (g_[i] < 0) {
        released = true;
        p_[i] = -step * g_[i];
      }
    }
    // After a direction without curvature, conjugation would repeat it forever.
    conjugate_ = !released && qt > 0;
    const double scale = normal_.is_force() ? scale_to_sum(p_, target_sum_) : 1.0;
    if (clipped || released || ++since_refresh_ >= refresh_interval) {
      refresh();
    } else {
      for (std::size_t i = 0; i < size_; ++i) u_[i] = scale * (u_[i] - step * q_[i]);
    }
  }

  const operators::NormalDisplacement& displacement_;
  const Field& initial_gap_;
  std::size_t size_;
  Given normal_;
  double target_sum_;
  Field p_, u_, g_, t_, q_;
  double approach_ = 0.0, norm_ = 0.0;
  bool conjugate_ = false;
  int since_refresh_ = 0, applications_ = 0, negative_curvatures_ = 0;
  ComplexField work_;
};

}  // namespace

Solution polonsky_keer(const operators::NormalDisplacement& displacement, const Field& initial_gap,
                       double cell_area, Given normal, Field pressure, double tol,
                       int max_iterations, double rounding) {
  ConjugateGradient iteration(displacement, initial_gap, cell_area, normal, std::move(pressure));
  return iteration.run(tol, max_iterations, rounding);
}

}  // namespace samcontact::contact
