// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/adhesive_slip.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/sweeps.hpp"

namespace samcontact::contact {
namespace {

/// Solutions for the normal displacement due to the shear, and the finest tolerance of it.
constexpr int max_solutions = 100;
constexpr double finest = 1e-12;

Drive drive_at(const RigidMotion& motion) {
  Drive drive = Drive::approach(motion.approach);
  for (int k = 0; k < 2; ++k) drive.tilt[k] = Given::motion(motion.tilt[k]);
  return drive;
}

}  // namespace

PartialSlipContact::AdhesiveSlip::AdhesiveSlip(const PartialSlipContact& contact, const Field& gap,
                                               const Drive& drive,
                                               const TangentialDrive& tangential,
                                               ContactHistory before,
                                               const ContactSettings& settings,
                                               const FrictionConditions& conditions)
    : contact_(contact),
      gap_(gap),
      drive_(drive),
      tangential_(tangential),
      settings_(settings),
      conditions_(conditions),
      before_(std::move(before)) {
  if (!before_.pressure.empty()) find_repulsion_before();
}

Field PartialSlipContact::AdhesiveSlip::raised_by(const Field& shear) {
  Field raised(gap_.size(), 0.0);
  if (contact_.is_coupled() && !shear.empty()) {
    contact_.coupling_.normal(shear.data(), raised.data(), work_);
  }
  return raised;
}

void PartialSlipContact::AdhesiveSlip::find_repulsion_before() {
  if (before_.gap.empty()) {
    Field displacement(gap_.size());
    contact_.normal_.displacement().apply(before_.pressure.data(), displacement.data(), work_);
    before_.gap = raised_by(before_.shear);
    const Lowering lowering(contact_.grid_, before_.motion);
    for (std::size_t i = 0; i < gap_.size(); ++i) {
      before_.gap[i] = std::max(before_.gap[i] + gap_[i] + displacement[i] - lowering(i), 0.0);
    }
  }
  pull_before_ = repulsion(*contact_.law_, before_.pressure, before_.gap);
  std::swap(pull_before_, before_.pressure);
  for (std::size_t i = 0; i < gap_.size(); ++i) {
    pull_before_[i] = before_.pressure[i] - pull_before_[i];
  }
}

ContactHistory PartialSlipContact::AdhesiveSlip::history_at(const Field& pull) {
  ContactHistory history = before_;
  if (!contact_.is_coupled()) return history;
  Field change = pull, slid(2 * gap_.size());
  if (!pull_before_.empty()) add_scaled(-1.0, pull_before_, change);
  contact_.coupling_.tangential(change.data(), slid.data(), work_);
  history.free_slip.resize(slid.size(), 0.0);
  add_scaled(1.0, slid, history.free_slip);
  return history;
}

PartialSlipSolution PartialSlipContact::AdhesiveSlip::slip_at(const Solution& adhesive,
                                                              const PartialSlipStart& start) {
  Field pull = attraction(*contact_.law_, adhesive.gap);
  const ContactHistory history = history_at(pull);
  const Attraction fixed(std::move(pull), contact_.grid_, contact_.normal_.displacement(), gap_);
  // Without stick in open cells whose pressure differs from the attraction by its error.
  Field pushed = repulsion(*contact_.law_, adhesive.tractions.pressure, adhesive.gap);
  const Field share = share_of_bound(pushed, adhesive.gap);
  const Drive drive = drive_at(adhesive.motion);
  const auto run = [&](Field pressure, const PartialSlipStart& from,
                       const FrictionConditions& given) {
    FrictionConditions local = given;
    if (local.factor.empty()) {
      local.factor = share;
    } else {
      for (std::size_t i = 0; i < share.size(); ++i) local.factor[i] *= share[i];
    }
    Sweeps sweeps(contact_, fixed.gap(), drive, tangential_, history, local, settings_);
    return contact_.finished(sweeps.run(std::move(pressure), from), drive_, fixed, settings_);
  };
  return contact_.with_conditions(run, std::move(pushed), start, conditions_,
                                  {false, settings_.tol});
}

Field PartialSlipContact::AdhesiveSlip::share_of_bound(const Field& pushed,
                                                       const Field& gap) const {
  if (!contact_.law_->rubs_by_compression()) return {};
  Field share = rubbing_pressure(*contact_.law_, pushed, gap);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const double whole = contact_.friction_.bound(pushed[i]);
    share[i] = whole > 0 ? contact_.friction_.bound(share[i]) / whole : 1.0;
  }
  return share;
}

bool PartialSlipContact::AdhesiveSlip::is_small(const Field& change, const Solution& adhesive) {
  const Field& pressure = adhesive.tractions.pressure;
  const Field repelling = repulsion(*contact_.law_, pressure, adhesive.gap);
  const double changed = largest_of(change.size(), [&](std::size_t i) {
    return in_contact(repelling[i]) ? std::fabs(change[i]) : 0.0;
  });
  // In open cells, the change of the gap also changes the attraction.
  const double pulled = largest_of(change.size(), [&](std::size_t i) {
    if (in_contact(repelling[i]) || change[i] == 0 || !std::isfinite(adhesive.gap[i])) return 0.0;
    const double open = std::max(adhesive.gap[i] + change[i], 0.0);
    return std::fabs(contact_.law_->attraction(open) - contact_.law_->attraction(adhesive.gap[i]));
  });
  const double tol = std::max(settings_.tol, finest);
  if (pulled > tol * contact_.law_->largest_attraction()) return false;
  if (changed == 0) return true;
  Field displacement(change.size());
  contact_.normal_.displacement().apply(pressure.data(), displacement.data(), work_);
  const double scale =
      largest_of(change.size(), [&](std::size_t i) { return std::fabs(displacement[i]); });
  return changed <= tol * scale;
}

PartialSlipSolution PartialSlipContact::AdhesiveSlip::run(const PartialSlipStart& start) {
  Field pressure = start.pressure;
  if (pressure.empty() && !before_.pressure.empty()) {
    pressure = before_.pressure;
    add_scaled(-1.0, pull_before_, pressure);
  }
  pressure.resize(gap_.size(), 0.0);
  Field raised = raised_by(start.shear);
  PartialSlipStart from = start;
  from.pressure.clear();
  PartialSlipSolution found;
  int iterations = 0;
  double work = 0.0;
  for (int n = 0; n < max_solutions; ++n) {
    Field lifted = gap_;
    add_scaled(1.0, raised, lifted);
    const Solution adhesive = contact_.adhesive_->solve(lifted, drive_, pressure, settings_.tol,
                                                        settings_.max_iterations);
    iterations += adhesive.iterations;
    work += adhesive.work;
    if (!adhesive.converged) {
      throw ConvergenceError("adhesive contact did not converge at " + describe(drive_) +
                                 ": error " + to_short_text(adhesive.error) + " after " +
                                 std::to_string(iterations) + " iterations, tol " +
                                 to_text(settings_.tol) +
                                 ": increase max_iterations or tol, or use smaller cells",
                             iterations, adhesive.error);
    }
    pressure = adhesive.tractions.pressure;
    found = slip_at(adhesive, from);
    iterations += found.normal.iterations;
    work += found.normal.work;
    Field change = std::exchange(raised, raised_by(found.tangential.shear));
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = raised[i] - change[i];
    if (is_small(change, adhesive)) {
      found.normal.iterations = iterations;
      found.normal.work = work;
      return found;
    }
    from = {{}, found.tangential.shear, found.tangential.sticking, found.tangential.motion, false};
  }
  throw ConvergenceError("adhesion with partial slip did not converge at " + describe(drive_) +
                             ": the displacement due to the shear still changes after " +
                             std::to_string(max_solutions) +
                             " solutions: reduce the increment, or increase tol",
                         iterations, found.normal.error);
}

}  // namespace samcontact::contact
