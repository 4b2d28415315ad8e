// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/polonsky_keer.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Number of steps after which the incrementally updated displacement is computed again, to remove
/// rounding errors.
constexpr int refresh_interval = 30;
/// Maximum number of times that a step is halved.
constexpr int max_step_halvings = 40;

class ConjugateGradient {
 public:
  ConjugateGradient(const operators::NormalDisplacement& displacement, const Field& initial_gap,
                    const RigidModes& modes, Field pressure)
      : displacement_(displacement),
        initial_gap_(initial_gap),
        size_(initial_gap.size()),
        modes_(modes),
        load_driven_(modes.normal().is_force()),
        p_(std::move(pressure)),
        u_(size_),
        g_(size_),
        t_(size_, 0.0),
        q_(size_) {
    modes_.meet_anywhere(initial_gap_, p_);
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
    solution.motion = motion_;
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

  void update_gap() {
    for_each_cell(size_, [&](std::ptrdiff_t i) { g_[i] = initial_gap_[i] + u_[i]; });
    motion_ = modes_.close(p_, g_);
  }

  /// p - step t in contact, and pressure on penetrating cells. Returns whether cells left or
  /// entered the contact.
  bool move(double step, bool& released) {
    bool clipped = false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (in_contact(p_[i])) {
        const double p = p_[i] - step * t_[i];
        clipped |= !in_contact(p);
        p_[i] = std::max(p, 0.0);
      } else if (g_[i] < 0) {
        released = true;
        p_[i] = -step * g_[i];
      }
    }
    return clipped || released;
  }

  /// Removes from the direction the mean and the plane, which would change load and moments.
  template <class Active>
  void project(const Active& active) {
    modes_.lower(modes_.slope(t_, active), t_);
    const double mean = contact_mean(p_, t_);
    for (std::size_t i = 0; i < size_; ++i) t_[i] = active(i) ? t_[i] - mean : 0.0;
  }

  /// A step with free tilts, shortened until the cells left in contact can carry the moments.
  bool move_with_moments(double step, bool& released) {
    const Field before = p_;
    for (int n = 0; n < max_step_halvings; ++n, step *= 0.5) {
      const bool changed = move(step, released);
      if (modes_.meet(p_)) return changed;
      p_ = before;
    }
    return true;
  }

  /// One projected conjugate-gradient step from the current gap.
  void advance() {
    const auto active = [&](std::size_t i) { return in_contact(p_[i]); };
    const double norm =
        ordered_sum(size_, [&](std::size_t i) { return active(i) ? g_[i] * g_[i] : 0.0; });
    const double beta = conjugate_ && norm_ > 0 ? norm / norm_ : 0.0;
    norm_ = norm;
    for (std::size_t i = 0; i < size_; ++i) t_[i] = active(i) ? g_[i] + beta * t_[i] : 0.0;
    if (modes_.tilts()) project(active);

    apply(t_, q_);
    if (modes_.tilts()) modes_.lower(modes_.slope(q_, active), q_);
    const double shift = load_driven_ ? contact_mean(p_, q_) : 0.0;
    const double gt = ordered_sum(size_, [&](std::size_t i) { return g_[i] * t_[i]; });
    const double qt = ordered_sum(size_, [&](std::size_t i) { return (q_[i] - shift) * t_[i]; });
    // Without an active cell with a residual there is no curvature: use the stiffness of the cell
    // itself.
    negative_curvatures_ += qt < 0;
    const double step = qt > 0 ? gt / qt : 1.0 / displacement_.self_influence();

    bool released = false;
    const bool changed = modes_.tilts() ? move_with_moments(step, released) : move(step, released);
    // After a direction without curvature, conjugation would repeat it forever.
    conjugate_ = !released && qt > 0;
    // With free tilts the pressure is no multiple of what it was.
    const double scale = modes_.tilts() ? 1.0 : modes_.scale(p_);
    if (changed || modes_.tilts() || ++since_refresh_ >= refresh_interval) {
      refresh();
    } else {
      for (std::size_t i = 0; i < size_; ++i) u_[i] = scale * (u_[i] - step * q_[i]);
    }
  }

  const operators::NormalDisplacement& displacement_;
  const Field& initial_gap_;
  std::size_t size_;
  const RigidModes& modes_;
  bool load_driven_;
  Field p_, u_, g_, t_, q_;
  RigidMotion motion_;
  double norm_ = 0.0;
  bool conjugate_ = false;
  int since_refresh_ = 0, applications_ = 0, negative_curvatures_ = 0;
  ComplexField work_;
};

}  // namespace

Solution polonsky_keer(const operators::NormalDisplacement& displacement, const Field& initial_gap,
                       const RigidModes& modes, Field pressure, double tol, int max_iterations,
                       double rounding) {
  ConjugateGradient iteration(displacement, initial_gap, modes, std::move(pressure));
  return iteration.run(tol, max_iterations, rounding);
}

}  // namespace samcontact::contact
