// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/contact/normal/first_contact.hpp"
#include "samcontact/contact/tangential/held_forces.hpp"
#include "samcontact/contact/tangential/slip_iteration.hpp"

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

}  // namespace

PartialSlipContact::Sweeps::Sweeps(const PartialSlipContact& contact, const Field& gap,
                                   const Drive& drive, const TangentialDrive& tangential,
                                   const ContactHistory& before, const FrictionConditions& friction,
                                   const ContactSettings& settings, bool rolls)
    : contact_(contact),
      gap_(gap),
      drive_(drive),
      modes_(drive, contact.grid_),
      tangential_(tangential),
      before_(before),
      friction_(friction),
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

PartialSlipSolution PartialSlipContact::Sweeps::run(Field pressure, const PartialSlipStart& start) {
  s_.tangential.shear = start.shear;
  s_.tangential.sticking = start.sticking;
  s_.tangential.motion = start.motion;
  const bool coupled = contact_.is_coupled();
  const bool joins = coupled && !rolls_ && settings_.after_stall != AfterStall::fail;
  if (joins && start.jointly && !start.shear.empty()) {
    s_.normal.tractions.pressure = pressure;
    s_.normal.error = s_.tangential.error = INFINITY;
    solve_jointly();
    if (s_.normal.converged) return std::move(s_);
    s_ = {};
    s_.tangential.shear = start.shear;
    s_.tangential.sticking = start.sticking;
    s_.tangential.motion = start.motion;
  }
  if (coupled && !start.shear.empty()) raise(start.shear, raised_);
  alternate(std::move(pressure));
  if (joins && !s_.normal.converged) solve_jointly();
  return std::move(s_);
}

void PartialSlipContact::Sweeps::alternate(Field pressure) {
  const bool coupled = contact_.is_coupled();
  const double full = settings_.tol, least = std::min(full, rounding);
  Anderson anderson(anderson_depth);
  double tol = coupled ? std::max(loosest, inner_safety * full) : full;
  for (;; ++s_.sweeps) {
    solve_pressure(std::move(pressure), tol);
    if (!s_.normal.converged) return;
    solve_shear(coupled || rolls_ || full > fine ? tol : std::max(shear_tol_ratio * full, least));
    const Field change = coupled ? update_gap() : Field{};
    s_.normal.converged = std::max(s_.normal.error, s_.tangential.error) <= full;
    if (s_.normal.converged || !coupled) return;
    if (!s_.tangential.converged || s_.sweeps >= max_sweeps) return;
    tol = std::max(inner_tol_ratio * s_.normal.error, inner_safety * full);
    anderson.next(raised_, change);
    pressure = s_.normal.tractions.pressure;
  }
}

void PartialSlipContact::Sweeps::solve_pressure(Field pressure, double tol) {
  Field gap = gap_;
  if (!raised_.empty()) add_scaled(1.0, raised_, gap);
  const Solution before = std::move(s_.normal);
  s_.normal =
      contact_.normal_.solve(gap, drive_, std::move(pressure), tol, settings_.max_iterations);
  s_.normal.iterations += before.iterations;
  s_.normal.operator_applications += before.operator_applications;
  s_.normal.work += before.work;
  require_held(contact_.grid_, tangential_, s_.normal.tractions.pressure, contact_.friction_,
               friction_.factor, rolls_ ? rolling_motions : increment_motions);
}

void PartialSlipContact::Sweeps::difference_per_distance(Field& displacement) const {
  const std::size_t row = contact_.grid_.ny;
  for (std::size_t at = 0; at < 2 * n_; ++at) {
    const bool is_last = at % n_ + row >= n_;
    displacement[at] =
        is_last ? 0.0 : (displacement[at] - displacement[at + row]) / contact_.grid_.dx;
  }
}

void PartialSlipContact::Sweeps::solve_shear(double tol) {
  const Solution& normal = s_.normal;
  const Field& p = normal.tractions.pressure;
  Field free_slip = before_.free_slip;
  if (contact_.is_coupled()) {
    Field slid(2 * n_);
    contact_.coupling_.tangential(p.data(), slid.data(), work_);
    free_slip.resize(2 * n_, 0.0);
    for (std::size_t i = 0; i < 2 * n_; ++i) {
      free_slip[i] += (displaced_before_.empty() ? 0.0 : displaced_before_[i]) - slid[i];
    }
  }
  if (rolls_ && !free_slip.empty()) difference_per_distance(free_slip);
  const Field touching = slip_part(p, normal.motion, normal.load);
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
                       rolls_,
                       friction_.factor};
  s_.tangential = contact_.shear_.solve(task, start, before.motion, tol, max_steps);
  s_.tangential.steps += before.steps;
  s_.tangential.iterations += before.iterations;
  s_.tangential.fallbacks += before.fallbacks;
  s_.tangential.operator_applications += before.operator_applications;
  s_.tangential.work += before.work;
}

Field PartialSlipContact::Sweeps::shear_before() const {
  if (before_.pressure.empty() || !(longest(before_.shear) > 0)) return {};
  Field shear = before_.shear;
  const FrictionLaw& law = contact_.friction_;
  // The bound of the previous increment is not known.
  if (law.prevents_slip() || !friction_.factor.empty()) return shear;
  const Stretch to_circle = law.stretch().inverse();
  for (std::size_t i = 0; i < n_; ++i) {
    const double p = before_.pressure[i], now = s_.normal.tractions.pressure[i];
    const double bound = law.bound(p);
    if (!(bound > 0) || to_circle.length(shear[i], shear[n_ + i]) < bound * on_circle) continue;
    const double grown = in_contact(now) ? law.ratio(now) / law.ratio(p) * (now / p) : 0.0;
    shear[i] *= grown;
    shear[n_ + i] *= grown;
  }
  return shear;
}

Field PartialSlipContact::Sweeps::slip_part(const Field& pressure, const RigidMotion& motion,
                                            double load) {
  double closer = motion.approach - before_.motion.approach;
  const bool tilts = motion.tilt != before_.motion.tilt;
  if (before_.pressure.empty() || before_.has_moved || !(closer > 0 || tilts)) return {};
  if (gap_before_.empty()) gap_before_ = find_gap_before();
  const Field scaled = tilts ? gap_of_uniform_approach(motion, closer) : Field{};
  if (!(closer > 0)) return {};
  const double contact = area(pressure);
  // Slip of round contacts so far, for a shear with this ratio to the pressure.
  const double ratio = contact_.friction_.ratio(contact > 0 ? load / contact : 0.0);
  const double most = 0.5 * (1 + contact_.crosswise_) * ratio * closer;
  return slip_after_contact(contact_.grid_,
                            {before_.pressure, pressure, tilts ? scaled : gap_before_, closer,
                             given_motion(contact), most},
                            contact_.crosswise_);
}

Field PartialSlipContact::Sweeps::gap_of_uniform_approach(const RigidMotion& motion,
                                                          double& closer) const {
  const Lowering now(contact_.grid_, motion), then(contact_.grid_, before_.motion);
  closer = 0.0;
  for (std::size_t i = 0; i < n_; ++i) closer = std::max(closer, now(i) - then(i));
  Field gap = gap_before_;
  // Cells that do not come closer touch due to other displacements, as late as the last ones.
  for (std::size_t i = 0; i < n_; ++i) {
    const double own = now(i) - then(i);
    gap[i] = own > 0 && gap[i] < own ? gap[i] / own * closer : std::max(gap[i], closer);
  }
  return gap;
}

double PartialSlipContact::Sweeps::area(const Field& pressure) const {
  const auto cells = std::count_if(pressure.begin(), pressure.end(), in_contact);
  return static_cast<double>(cells) * contact_.grid_.cell_area();
}

double PartialSlipContact::Sweeps::given_motion(double area) const {
  const auto given = [this](int k) {
    return tangential_[k].is_force() ? 0.0 : tangential_[k].value;
  };
  const double size = std::sqrt(area);
  return std::hypot(given(0), given(1)) + 0.5 * size * std::fabs(given(2));
}

Field PartialSlipContact::Sweeps::find_gap_before() {
  Field gap(n_), raised(n_, 0.0);
  contact_.normal_.displacement().apply(before_.pressure.data(), gap.data(), work_);
  if (contact_.is_coupled()) {
    contact_.coupling_.normal(before_.shear.data(), raised.data(), work_);
  }
  const Lowering lowering(contact_.grid_, before_.motion);
  for (std::size_t i = 0; i < n_; ++i) gap[i] += gap_[i] + raised[i] - lowering(i);
  return gap;
}

void PartialSlipContact::Sweeps::raise(const Field& shear, Field& raised) {
  contact_.coupling_.normal(shear.data(), raised.data(), work_);
}

Field PartialSlipContact::Sweeps::update_gap() {
  Solution& s = s_.normal;
  const Field& p = s.tractions.pressure;
  Field change(n_), displacement(n_, 0.0);
  raise(s_.tangential.shear, change);
  add_scaled(-1.0, raised_, change);
  const Lowering lowering(contact_.grid_, s.motion);
  for (std::size_t i = 0; i < n_; ++i) {
    // The displacement is unknown in cells without a body.
    if (std::isinf(gap_[i])) continue;
    displacement[i] = s.gap[i] - gap_[i] - raised_[i] + lowering(i);
  }
  add_scaled(1.0, change, s.gap);
  if (drive_.normal.is_force()) {
    const RigidMotion closer = modes_.close(p, s.gap);
    s.motion.approach += closer.approach;
    for (int k = 0; k < 2; ++k) s.motion.tilt[k] += closer.tilt[k];
  }
  s.error = complementarity_error(p, displacement, s.gap, s.rounding);
  return change;
}

}  // namespace samcontact::contact
