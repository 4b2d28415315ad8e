// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/partial_slip_contact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/contact/normal/first_contact.hpp"
#include "samcontact/contact/tangential/held_forces.hpp"

namespace samcontact::contact {
namespace {

constexpr int max_sweeps = 100, max_steps = 100;
/// Number of sweeps used by the acceleration: cells change sides between sweeps, which makes older
/// ones useless.
constexpr int anderson_depth = 4;
/// Tolerance within a sweep: relative to the error of the previous sweep, and in the first sweep.
constexpr double inner_tol_ratio = 0.1, loosest = 1e-2;
/// Factor of the tolerance, so that the last sweep stays within it.
constexpr double inner_safety = 0.5;
/// e_t is relative to the stiffness of the whole contact, and the shear of single cells is off by
/// up to 25 times as much: tolerances below `fine`, except those near rounding, are multiplied by
/// this factor.
constexpr double shear_tol_ratio = 0.5, fine = 1e-6, rounding = 1e-12;
/// A shear of at least this fraction of its bound is on it.
constexpr double on_circle = 1 - 1e-9;
/// Friction ratio of dissimilar materials above which an increment may have no solution: a cell
/// whose shear lifts it is in tension if it sticks, and interpenetrates if it is free.
constexpr double always_solved = 2;

operators::SurfaceInfluence frictionless(const operators::SharedMedium& body1,
                                         const operators::SharedMedium& body2) {
  if (body1->is_rigid() && body2->is_rigid()) {
    throw std::invalid_argument("body1 and body2 are both rigid: at least one must be deformable");
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

}  // namespace

PartialSlipContact::PartialSlipContact(const Grid& grid, const operators::SharedMedium& body1,
                                       const operators::SharedMedium& body2,
                                       const FrictionLaw& friction, SharedContactLaw law)
    : grid_(grid),
      friction_(friction),
      law_(std::move(law)),
      crosswise_(crosswise_compliance(grid, {body1, body2})),
      normal_(grid, frictionless(body1, body2)),
      shear_(grid, {body1, body2}),
      coupling_(grid, {body1, body2}) {
  assert(friction.sticks());
}

/// Solution of one increment.
class PartialSlipContact::Sweeps {
 public:
  Sweeps(const PartialSlipContact& contact, const Field& gap, Given normal,
         const TangentialDrive& tangential, const ContactHistory& before,
         const ContactSettings& settings, bool rolls = false)
      : contact_(contact),
        gap_(gap),
        normal_(normal),
        tangential_(tangential),
        before_(before),
        settings_(settings),
        rolls_(rolls),
        n_(gap.size()),
        gap_before_(before.gap) {
    if (!contact_.is_coupled()) return;
    raised_.resize(n_, 0.0);
    if (before.pressure.empty()) return;
    displaced_before_.resize(2 * n_);
    contact_.coupling_.tangential(before.pressure.data(), displaced_before_.data(), work_);
    raise(before.shear, raised_);
  }

  /// Coupled bodies interact through raised_, which is iterated until it equals the displacement
  /// due to the shear.
  PartialSlipSolution run(Field pressure, const PartialSlipStart& start) {
    s_.tangential.shear = start.shear;
    s_.tangential.sticking = start.sticking;
    s_.tangential.motion = start.motion;
    if (contact_.is_coupled() && !start.shear.empty()) raise(start.shear, raised_);
    const bool coupled = contact_.is_coupled();
    const double full = settings_.tol, least = std::min(full, rounding);
    Anderson anderson(anderson_depth);
    double tol = coupled ? std::max(loosest, inner_safety * full) : full;
    for (;; ++s_.sweeps) {
      solve_pressure(std::move(pressure), tol);
      if (!s_.normal.converged) return std::move(s_);
      solve_shear(coupled || rolls_ || full > fine ? tol : std::max(shear_tol_ratio * full, least));
      const Field change = coupled ? update_gap() : Field{};
      s_.normal.converged = std::max(s_.normal.error, s_.tangential.error) <= full;
      if (s_.normal.converged || !coupled) break;
      if (!s_.tangential.converged || s_.sweeps >= max_sweeps) break;
      tol = std::max(inner_tol_ratio * s_.normal.error, inner_safety * full);
      anderson.next(raised_, change);
      pressure = s_.normal.tractions.pressure;
    }
    return std::move(s_);
  }

 private:
  /// Solves for the pressure at the present normal displacement due to shear.
  void solve_pressure(Field pressure, double tol) {
    Field gap = gap_;
    if (!raised_.empty()) add_scaled(1.0, raised_, gap);
    const Solution before = std::move(s_.normal);
    s_.normal =
        contact_.normal_.solve(gap, normal_, std::move(pressure), tol, settings_.max_iterations);
    s_.normal.iterations += before.iterations;
    s_.normal.operator_applications += before.operator_applications;
    s_.normal.work += before.work;
    require_held(contact_.grid_, tangential_, s_.normal.tractions.pressure, contact_.friction_,
                 rolls_ ? rolling_motions : increment_motions);
  }

  /// Replaces a displacement by its decrease from the next cell ahead, per distance rolled.
  void difference_per_distance(Field& displacement) const {
    const std::size_t row = contact_.grid_.ny;
    for (std::size_t at = 0; at < 2 * n_; ++at) {
      const bool is_last = at % n_ + row >= n_;
      displacement[at] =
          is_last ? 0.0 : (displacement[at] - displacement[at + row]) / contact_.grid_.dx;
    }
  }

  /// Solves for the shear under the present pressure.
  void solve_shear(double tol) {
    const Field& p = s_.normal.tractions.pressure;
    Field free_slip = before_.free_slip;
    if (contact_.is_coupled()) {
      Field slid(2 * n_);
      contact_.coupling_.tangential(p.data(), slid.data(), work_);
      free_slip.resize(2 * n_, 0.0);
      for (std::size_t i = 0; i < 2 * n_; ++i) {
        free_slip[i] += (displaced_before_.empty() ? 0.0 : displaced_before_[i]) - slid[i];
      }
      if (rolls_) difference_per_distance(free_slip);
    }
    const Field touching = slip_part();
    const bool first = s_.tangential.shear.empty();
    const Field start = first ? shear_before() : std::move(s_.tangential.shear);
    const std::vector<unsigned char> sticking = std::move(s_.tangential.sticking);
    const ShearSolution before = std::move(s_.tangential);
    const bool has_sticking = !sticking.empty();
    const ShearTask task{p,
                         contact_.friction_,
                         before_.shear,
                         free_slip,
                         tangential_,
                         &slid_by_shear_,
                         touching.empty() ? nullptr : &touching,
                         has_sticking ? &sticking : nullptr,
                         rolls_};
    s_.tangential = contact_.shear_.solve(task, start, before.motion, tol, max_steps);
    s_.tangential.steps += before.steps;
    s_.tangential.iterations += before.iterations;
    s_.tangential.fallbacks += before.fallbacks;
    s_.tangential.operator_applications += before.operator_applications;
    s_.tangential.work += before.work;
  }

  /// Shear of the history, scaled to the present bound in cells that slipped; empty: none.
  Field shear_before() const {
    if (before_.pressure.empty() || !(longest(before_.shear) > 0)) return {};
    Field shear = before_.shear;
    const FrictionLaw& law = contact_.friction_;
    if (law.prevents_slip()) return shear;
    for (std::size_t i = 0; i < n_; ++i) {
      const double p = before_.pressure[i], now = s_.normal.tractions.pressure[i];
      const double bound = law.bound(p);
      if (!(bound > 0) || std::hypot(shear[i], shear[n_ + i]) < bound * on_circle) continue;
      const double grown = in_contact(now) ? law.ratio(now) / law.ratio(p) * (now / p) : 0.0;
      shear[i] *= grown;
      shear[n_ + i] *= grown;
    }
    return shear;
  }

  /// Part of a rigid motion that newly contacting cells slip; empty if there are none, and before
  /// the first contact, for which the normal load is applied first.
  Field slip_part() {
    const double closer = s_.normal.motion.approach - before_.approach;
    if (before_.pressure.empty() || before_.has_moved || !(closer > 0)) return {};
    if (gap_before_.empty()) gap_before_ = find_gap_before();
    // Slip of round contacts so far, for a shear with this ratio to the pressure.
    const double ratio = contact_.friction_.ratio(mean_pressure());
    const double most = 0.5 * (1 + contact_.crosswise_) * ratio * closer;
    return slip_after_contact(
        contact_.grid_,
        {before_.pressure, s_.normal.tractions.pressure, gap_before_, closer, given_motion(), most},
        contact_.crosswise_);
  }

  /// Contact area [m^2].
  double area() const {
    const Field& p = s_.normal.tractions.pressure;
    const auto cells = std::count_if(p.begin(), p.end(), in_contact);
    return static_cast<double>(cells) * contact_.grid_.cell_area();
  }
  double mean_pressure() const {
    const double contact = area();
    return contact > 0 ? s_.normal.load / contact : 0.0;
  }

  /// Approximate maximum of the prescribed slip [m].
  double given_motion() const {
    const auto given = [this](int k) {
      return tangential_[k].is_force() ? 0.0 : tangential_[k].value;
    };
    const double size = std::sqrt(area());
    return std::hypot(given(0), given(1)) + 0.5 * size * std::fabs(given(2));
  }

  /// Gap of the present undeformed surfaces under the previous tractions.
  Field find_gap_before() {
    Field gap(n_), raised(n_, 0.0);
    contact_.normal_.displacement().apply(before_.pressure.data(), gap.data(), work_);
    if (contact_.is_coupled()) {
      contact_.coupling_.normal(before_.shear.data(), raised.data(), work_);
    }
    for (std::size_t i = 0; i < n_; ++i) gap[i] += gap_[i] + raised[i] - before_.approach;
    return gap;
  }

  void raise(const Field& shear, Field& raised) {
    contact_.coupling_.normal(shear.data(), raised.data(), work_);
  }

  /// Updates gap and pressure error for the present shear; returns the normal displacement due to
  /// the shear in excess of raised_.
  Field update_gap() {
    Solution& s = s_.normal;
    const Field& p = s.tractions.pressure;
    Field change(n_), displacement(n_, 0.0);
    raise(s_.tangential.shear, change);
    add_scaled(-1.0, raised_, change);
    for (std::size_t i = 0; i < n_; ++i) {
      // The displacement is unknown in cells without a body.
      if (std::isinf(gap_[i])) continue;
      displacement[i] = s.gap[i] - gap_[i] - raised_[i] + s.motion.approach;
    }
    add_scaled(1.0, change, s.gap);
    if (normal_.is_force()) {
      const double closer = contact_mean(p, s.gap);
      for (double& g : s.gap) g -= closer;
      s.motion.approach += closer;
    }
    s.error = complementarity_error(p, displacement, s.gap, s.rounding);
    return change;
  }

  const PartialSlipContact& contact_;
  const Field& gap_;
  const Given normal_;
  const TangentialDrive& tangential_;
  const ContactHistory& before_;
  const ContactSettings& settings_;
  const bool rolls_;
  const std::size_t n_;
  Field raised_;            // assumed B s; empty if it is zero
  Field gap_before_;        // empty: unknown
  Field displaced_before_;  // B' p of the history
  PreviousDisplacement slid_by_shear_;
  ComplexField work_;
  PartialSlipSolution s_;
};

namespace {

void require_solved(const PartialSlipSolution& solution, Given normal,
                    const ContactSettings& settings, bool may_have_none) {
  const ShearSolution& shear = solution.tangential;
  if (!is_finite(solution.normal) || !all_finite(shear.shear) || !all_finite(shear.slip)) {
    throw ConvergenceError("partial slip did not converge at " + describe(Drive{normal}) +
                               ": the solution is not finite",
                           solution.normal.iterations + shear.iterations, solution.normal.error);
  }
  if (solution.normal.converged) return;
  std::string text = "partial slip did not converge at " + describe(Drive{normal}) + ": ";
  if (shear.converged && solution.normal.error > settings.tol) {
    text += "pressure error " + to_short_text(solution.normal.error);
  } else {
    text += "shear error " + to_short_text(shear.error);
  }
  text += " after " + std::to_string(solution.sweeps) + " sweeps, tol " + to_text(settings.tol) +
          "; reached tangential_load = (" + to_short_text(shear.force[0], 6) + ", " +
          to_short_text(shear.force[1], 6) + ") N, torque = " + to_short_text(shear.force[2], 6) +
          " N m: reduce the force or increment, or increase tol";
  if (may_have_none) {
    text +=
        "; the problem may have no solution for dissimilar materials at this friction: edge cells "
        "can neither stick nor separate: use friction of at most " +
        to_text(always_solved) + " times the pressure";
  }
  throw ConvergenceError(text, solution.normal.iterations + shear.iterations,
                         std::max(shear.error, solution.normal.error));
}

}  // namespace

void PartialSlipContact::require_contact(const Field& gap, Given normal,
                                         const ContactHistory& before) const {
  require_gap(gap, grid_, "gap");
  if (!before.pressure.empty()) {
    require_surface(before.pressure, grid_, "previous.pressure");
    require_vectors(before.shear, grid_, "previous.shear");
    if (!before.gap.empty()) require_gap(before.gap, grid_, "previous.gap");
  }
  require_valid(Drive{normal}, *law_);
  require_below_mean(grid_, gap, normal);
}

PartialSlipSolution PartialSlipContact::finished(PartialSlipSolution solution, Given normal,
                                                 const Attraction& attraction,
                                                 const ContactSettings& settings) const {
  require_solved(solution, normal, settings, is_coupled() && friction_.ratio(0.0) > always_solved);
  Solution& pressed = solution.normal;
  pressed.edge_warning = edge_warning(grid_, pressed.tractions.pressure, describe(Drive{normal}));
  if (!pressed.edge_warning.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, pressed.tractions.pressure, pressed.edge_warning);
  }
  pressed = attraction.with_attraction(std::move(pressed), normal);
  return solution;
}

PartialSlipSolution PartialSlipContact::solve(const Field& gap, Given normal,
                                              const TangentialDrive& tangential,
                                              const ContactHistory& before,
                                              const PartialSlipStart& start,
                                              const ContactSettings& settings) const {
  require_contact(gap, normal, before);
  if (!start.pressure.empty()) require_surface(start.pressure, grid_, "initial_pressure");
  const Attraction attraction(*law_, grid_, normal_.displacement(), gap);
  const Given repelling = attraction.normal(normal);
  if (normal.is_force()) require_held(tangential, friction_, repelling.value, increment_motions);
  ContactHistory repelled;
  if (law_->attracts()) {
    repelled = before;
    repelled.pressure = attraction.repulsion(before.pressure);
  }
  const ContactHistory& history = law_->attracts() ? repelled : before;
  Field repulsion =
      start.pressure.empty() ? history.pressure : attraction.repulsion(start.pressure);
  repulsion.resize(gap.size(), 0.0);
  for (double& r : repulsion) r = std::max(r, 0.0);
  Sweeps sweeps(*this, attraction.gap(), repelling, tangential, history, settings);
  return finished(sweeps.run(std::move(repulsion), start), normal, attraction, settings);
}

PartialSlipSolution PartialSlipContact::roll(const Field& gap, Given normal,
                                             const TangentialDrive& creepage,
                                             const PartialSlipStart& start,
                                             const ContactSettings& settings) const {
  require_contact(gap, normal, {start.pressure, start.shear, {}});
  const Attraction attraction(*law_, grid_, normal_.displacement(), gap);
  const Given repelling = attraction.normal(normal);
  if (normal.is_force()) require_held(creepage, friction_, repelling.value, rolling_motions);
  const ContactHistory none;
  PartialSlipStart begin = start;
  begin.pressure = attraction.repulsion(std::move(begin.pressure));
  begin.pressure.resize(gap.size(), 0.0);
  // Without an initial shear, start from coarser boxes.
  if (!begin.shear.empty() && !(longest(begin.shear) > 0)) begin.shear.clear();
  Sweeps sweeps(*this, attraction.gap(), repelling, creepage, none, settings, true);
  return finished(sweeps.run(begin.pressure, begin), normal, attraction, settings);
}

}  // namespace samcontact::contact
