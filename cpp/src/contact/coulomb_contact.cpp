// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/coulomb_contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "samcontact/contact/anderson.hpp"

namespace samcontact::contact {
namespace {

constexpr int most_sweeps = 100, most_steps = 100;
/// Sweeps remembered: cells change sides between them, which makes the older ones useless.
constexpr int anderson_depth = 4;
/// What is solved within a sweep, of the last change; looser makes the changes oscillate. It gets
/// tighter from sweep to sweep: one that does nothing because it may be loose tells nothing.
constexpr double inner_share = 0.1, loosest = 1e-2, tighter = 0.1;
/// Rigid motions below this share of the approach are none.
constexpr double smallest_motion = 1e-9;
/// A force this close to the largest has no definite motion.
constexpr double least_margin = 1e-8;

operators::SurfaceInfluence frictionless(const operators::SharedMedium& body1,
                                         const operators::SharedMedium& body2) {
  if (body1->is_rigid() && body2->is_rigid()) {
    throw std::invalid_argument("body1 and body2 are both rigid: at least one must be elastic");
  }
  operators::SurfaceInfluence influence;
  influence.add(body1);
  influence.add(body2);
  return influence;
}

void require_vectors(const Field& field, const Grid& grid, const std::string& name) {
  if (field.size() != 2 * grid.surface_size()) {
    throw std::invalid_argument(name + " must have shape (2, " + std::to_string(grid.nx) + ", " +
                                std::to_string(grid.ny) + ")");
  }
  require(std::all_of(field.begin(), field.end(), [](double s) { return std::isfinite(s); }), name,
          "finite everywhere", NAN);
}

double force_of(const Given& given) { return given.is_force() ? given.value : 0.0; }

constexpr const char* beyond =
    ", the largest that friction holds; at it everything slides and the motion is not determined "
    "by "
    "the force: give the motion (";

/// Throws where no shear has the force. most: friction times the load [N].
void require_held(const TangentialDrive& drive, double most) {
  const double force = std::hypot(force_of(drive[0]), force_of(drive[1]));
  require(
      force == 0 || force < most * (1 - least_margin), "tangential_load",
      "shorter than friction times the load, " + to_text(most) + " N" + beyond + "shift) instead",
      force);
}

/// The same under a pressure, of the torque too.
void require_held(const Grid& grid, const TangentialDrive& drive, const Field& pressure,
                  double friction) {
  if (std::isinf(friction)) return;
  const LargestForces most = largest_forces(grid, pressure, friction);
  require_held(drive, most.along);
  const double torque = force_of(drive[2]);
  require(torque == 0 || std::fabs(torque) < most.torque * (1 - least_margin), "torque",
          "smaller than " + to_text(most.torque) + " N m" + beyond + "twist) instead", torque);
}

/// Relative to what the natural residual is: the largest bound, or ten times the shear where that
/// is much less, as long as it is more than rounding.
double change_of(const Field& from, const Field& to, double largest_pressure, double friction) {
  Field difference = to;
  add_scaled(-1.0, from, difference);
  const double shear = 10 * std::max(longest(to), longest(from));
  const double scale = std::max(std::min(friction * largest_pressure, shear),
                                smallest_share * std::min(friction, 1.0) * largest_pressure);
  return scale > 0 ? longest(difference) / scale : 0.0;
}

}  // namespace

CoulombContact::CoulombContact(const Grid& grid, const operators::SharedMedium& body1,
                               const operators::SharedMedium& body2, double friction)
    : grid_(grid),
      friction_(friction),
      normal_(grid, frictionless(body1, body2)),
      shear_(grid, {body1, body2}),
      coupling_(grid, {body1, body2}) {
  require(friction >= 0, "friction", "a number >= 0, or infinite", friction);
}

/// One increment.
class CoulombContact::Sweeps {
 public:
  Sweeps(const CoulombContact& contact, const Field& gap, Given normal,
         const TangentialDrive& tangential, const ContactHistory& before,
         const ContactSettings& settings)
      : contact_(contact),
        gap_(gap),
        normal_(normal),
        tangential_(tangential),
        before_(before),
        settings_(settings),
        n_(gap.size()),
        size_(0.5 *
              std::hypot(contact.grid_.nx * contact.grid_.dx, contact.grid_.ny * contact.grid_.dy)),
        raised_(n_, 0.0),
        gap_before_(before.gap),
        motion_(3, 0.0) {
    for (int k = 0; k < 3; ++k) {
      if (!tangential[k].is_force()) motion_[k] = tangential[k].value * (k == 2 ? size_ : 1.0);
    }
    if (contact_.is_coupled() && !before.pressure.empty()) {
      slid_before_.resize(2 * n_);
      contact_.coupling_.tangential(before.pressure.data(), slid_before_.data(), work_);
    }
  }

  CoulombSolution run(Field pressure, const CoulombStart& start) {
    Field shear = start.shear.empty() ? before_.shear : start.shear;
    s_.tangential.motion = start.motion;
    if (!contact_.is_coupled()) {
      press(std::move(pressure), settings_.tol);
      slide(shear, settings_.tol);
      s_.normal.converged = s_.normal.converged && s_.tangential.converged;
      return std::move(s_);
    }
    shear.resize(2 * n_, 0.0);
    iterate(std::move(pressure), std::move(shear));
    return std::move(s_);
  }

 private:
  /// Pressure under the shear that raised_ belongs to.
  void press(Field pressure, double tol) {
    Field gap = gap_;
    for (std::size_t i = 0; i < n_; ++i) gap[i] += raised_[i];
    const Solution before = std::move(s_.normal);
    s_.normal =
        contact_.normal_.solve(gap, normal_, std::move(pressure), tol, settings_.max_iterations);
    s_.normal.iterations += before.iterations;
    s_.normal.operator_applications += before.operator_applications;
    s_.normal.work += before.work;
    require_held(contact_.grid_, tangential_, s_.normal.tractions.pressure, contact_.friction_);
  }

  /// Shear under the present pressure, starting from one.
  void slide(const Field& start, double tol) {
    Field free_slip = before_.free_slip;
    if (contact_.is_coupled()) {
      Field slid(2 * n_);
      contact_.coupling_.tangential(s_.normal.tractions.pressure.data(), slid.data(), work_);
      free_slip.resize(2 * n_, 0.0);
      for (std::size_t i = 0; i < 2 * n_; ++i) {
        free_slip[i] += (slid_before_.empty() ? 0.0 : slid_before_[i]) - slid[i];
      }
    }
    const Field shares = shares_before_touch();
    if (shares.empty()) return solve_shear(free_slip, start, tol);
    free_slip.resize(2 * n_, 0.0);
    Anderson anderson(anderson_depth);
    for (int n = 0;; ++n) {
      solve_shear(without_motion(free_slip, shares), n == 0 ? start : Field(s_.tangential.shear),
                  tol);
      Field residual(3);
      const double change = motion_residual(residual);
      if (change <= tol) return;
      if (n == most_sweeps) {
        s_.tangential.error = std::max(s_.tangential.error, change);
        s_.tangential.converged = false;
        return;
      }
      anderson.next(motion_, residual);
    }
  }

  void solve_shear(const Field& free_slip, const Field& start, double tol) {
    const Field& p = s_.normal.tractions.pressure;
    const ShearSolution before = std::move(s_.tangential);
    const ShearTask task{p,         contact_.friction_, before_.shear,
                         free_slip, tangential_,        &slid_by_shear_};
    s_.tangential = contact_.shear_.solve(task, start, before.motion, tol, most_steps);
    s_.tangential.steps += before.steps;
    s_.tangential.iterations += before.iterations;
    s_.tangential.fallbacks += before.fallbacks;
    s_.tangential.operator_applications += before.operator_applications;
    s_.tangential.work += before.work;
  }

  /// Of each cell that touches for the first time, the share of the increment before it does: rigid
  /// bodies that approach steadily close its gap then, and the elastic displacement changes what
  /// they slip and what they close in the same proportion. Empty where there is none, and before
  /// the first contact: it is pressed, then sheared.
  Field shares_before_touch() {
    Field shares;
    const double closer = s_.normal.motion.approach - before_.approach;
    if (before_.pressure.empty() || !(closer > 0)) return shares;
    if (gap_before_.empty()) gap_before_ = find_gap_before();
    for (std::size_t i = 0; i < n_; ++i) {
      if (!(s_.normal.tractions.pressure[i] > 0) || before_.pressure[i] > 0) continue;
      if (!(gap_before_[i] > 0)) continue;
      if (shares.empty()) shares.assign(n_, 0.0);
      shares[i] = std::min(gap_before_[i] / closer, 1.0);
    }
    return shares;
  }

  /// Of the undeformed surfaces as they are now.
  Field find_gap_before() {
    Field gap(n_), raised(n_, 0.0);
    contact_.normal_.displacement().apply(before_.pressure.data(), gap.data(), work_);
    if (contact_.is_coupled()) {
      contact_.coupling_.normal(before_.shear.data(), raised.data(), work_);
    }
    for (std::size_t i = 0; i < n_; ++i) gap[i] += gap_[i] + raised[i] - before_.approach;
    return gap;
  }

  /// Free slip less that of the rigid motion before cells touch.
  Field without_motion(Field free_slip, const Field& shares) const {
    const Grid& grid = contact_.grid_;
    const std::vector<double> x = grid.x(), y = grid.y();
    for (std::size_t at = 0; at < n_; ++at) {
      free_slip[at] -= shares[at] * (motion_[0] - motion_[2] / size_ * y[at % grid.ny]);
      free_slip[n_ + at] -= shares[at] * (motion_[1] + motion_[2] / size_ * x[at / grid.ny]);
    }
    return free_slip;
  }

  /// What the motion is now less what it was taken for, and its share.
  double motion_residual(Field& residual) const {
    double largest = smallest_motion * std::fabs(s_.normal.motion.approach), change = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double now = s_.tangential.motion[k] * (k == 2 ? size_ : 1.0);
      residual[k] = now - motion_[k];
      largest = std::max(largest, std::fabs(now));
      change = std::max(change, std::fabs(residual[k]));
    }
    return largest > 0 ? change / largest : 0.0;
  }

  void raise(const Field& shear) { contact_.coupling_.normal(shear.data(), raised_.data(), work_); }

  void iterate(Field pressure, Field shear) {
    Anderson anderson(anderson_depth);
    // The residuals of two sweeps make a change even where nothing changes any more.
    const double full = settings_.tol,
                 tightest = std::clamp(1e-2 * full, std::min(full, 1e-12), full);
    double change = 1.0, tol = loosest;
    bool warm = longest(shear) > 0;
    raise(shear);
    for (s_.sweeps = 1;; ++s_.sweeps) {
      if (s_.sweeps > 1) tol = std::max(std::min(inner_share * change, tighter * tol), tightest);
      press(std::move(pressure), std::max(0.3 * tol, 1e-13));
      if (!s_.normal.converged) return;
      slide(warm ? shear : Field{}, tol);
      warm = true;
      const Field& p = s_.normal.tractions.pressure;
      change = change_of(shear, s_.tangential.shear, *std::max_element(p.begin(), p.end()),
                         contact_.friction_);
      s_.normal.converged = change <= full && tol <= full && s_.tangential.converged;
      if (s_.normal.converged || s_.sweeps >= most_sweeps) break;
      Field residual = s_.tangential.shear;
      add_scaled(-1.0, shear, residual);
      anderson.next(shear, residual);
      raise(shear);
      pressure = p;
    }
    s_.tangential.error += change;
    settle();
  }

  /// The gap under the shear found, not that of the sweep before.
  void settle() {
    const Field before = raised_;
    raise(s_.tangential.shear);
    for (std::size_t i = 0; i < n_; ++i) s_.normal.gap[i] += raised_[i] - before[i];
    if (!normal_.is_force()) return;
    const double closer = contact_mean(s_.normal.tractions.pressure, s_.normal.gap);
    for (double& g : s_.normal.gap) g -= closer;
    s_.normal.motion.approach += closer;
  }

  const CoulombContact& contact_;
  const Field& gap_;
  const Given normal_;
  const TangentialDrive& tangential_;
  const ContactHistory& before_;
  const ContactSettings& settings_;
  const std::size_t n_;
  const double size_;  // a turn times it is a length
  Field raised_;       // B s of the present shear
  Field gap_before_;   // empty: not known
  Field slid_before_;  // B' p of the history
  Field motion_;       // x, y and turn that cells which touch are taken to make [m]
  SlidBefore slid_by_shear_;
  ComplexField work_;
  CoulombSolution s_;
};

namespace {

void require_solved(const CoulombSolution& solution, Given normal,
                    const ContactSettings& settings) {
  if (solution.normal.converged) return;
  const ShearSolution& shear = solution.tangential;
  std::string text = "stick and slip did not converge at " + describe(Drive{normal}) + ": ";
  if (shear.converged && solution.normal.error > settings.tol) {
    text += "error of the pressure " + to_text(solution.normal.error);
  } else {
    text += "error of the shear " + to_text(shear.error);
  }
  text += " after " + std::to_string(solution.sweeps) + " sweeps, tol " + to_text(settings.tol) +
          "; reached: tangential_load = (" + to_text(shear.force[0]) + ", " +
          to_text(shear.force[1]) + ") N, torque = " + to_text(shear.force[2]) +
          " N m: take a smaller force or increment, or a larger tol";
  throw ConvergenceError(text, solution.normal.iterations + shear.iterations,
                         std::max(shear.error, solution.normal.error));
}

}  // namespace

CoulombSolution CoulombContact::solve(const Field& gap, Given normal,
                                      const TangentialDrive& tangential,
                                      const ContactHistory& before, const CoulombStart& start,
                                      const ContactSettings& settings) const {
  require_surface(gap, grid_, "gap");
  if (!start.pressure.empty()) require_surface(start.pressure, grid_, "initial_pressure");
  if (!before.pressure.empty()) {
    require_surface(before.pressure, grid_, "previous.pressure");
    require_vectors(before.shear, grid_, "previous.shear");
    if (!before.gap.empty()) require_surface(before.gap, grid_, "previous.gap");
  }
  require_valid(Drive{normal});
  if (normal.is_force() && !std::isinf(friction_))
    require_held(tangential, friction_ * normal.value);
  require_below_mean(grid_, gap, normal);
  Field pressure = start.pressure.empty() ? before.pressure : start.pressure;
  pressure.resize(gap.size(), 0.0);
  for (double& p : pressure) p = std::max(p, 0.0);
  CoulombSolution solution =
      Sweeps(*this, gap, normal, tangential, before, settings).run(std::move(pressure), start);
  require_solved(solution, normal, settings);
  Solution& pressed = solution.normal;
  pressed.border_complaint =
      border_complaint(grid_, pressed.tractions.pressure, describe(Drive{normal}));
  if (!pressed.border_complaint.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, pressed.tractions.pressure, pressed.border_complaint);
  }
  return solution;
}

}  // namespace samcontact::contact
