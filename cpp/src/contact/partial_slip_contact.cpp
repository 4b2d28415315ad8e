// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/partial_slip_contact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/contact/adhesive_slip.hpp"
#include "samcontact/contact/layer_hardening.hpp"
#include "samcontact/contact/normal/first_contact.hpp"
#include "samcontact/contact/pulled_layer.hpp"
#include "samcontact/contact/slip_rate.hpp"
#include "samcontact/contact/sweeps.hpp"
#include "samcontact/contact/tangential/held_forces.hpp"

namespace samcontact::contact {
namespace {

operators::SurfaceInfluence frictionless(const operators::SharedMedium& body1,
                                         const operators::SharedMedium& body2) {
  require_deformable(!body1->is_rigid() || !body2->is_rigid());
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
      adhesive_(law_->varies()
                    ? std::make_unique<AdhesiveContact>(grid, frictionless(body1, body2), law_)
                    : nullptr),
      crosswise_(crosswise_compliance(grid, {body1, body2})),
      normal_(grid, frictionless(body1, body2)),
      shear_(grid, {body1, body2, friction.compliance()}),
      coupling_(grid, {body1, body2}),
      joint_(grid, {body1, body2, friction.compliance()}) {
  assert(friction.sticks());
}

namespace {

/// Text with the error of a solution and the forces reached.
std::string describe_error(const PartialSlipSolution& solution, double tol) {
  const ShearSolution& shear = solution.tangential;
  std::string text;
  if (shear.converged && solution.normal.error > tol) {
    text += "pressure error " + to_short_text(solution.normal.error);
  } else {
    text += "shear error " + to_short_text(shear.error);
  }
  text += " after " + std::to_string(solution.sweeps) + " sweeps";
  if (solution.joint.steps > 0) {
    text += " and " + std::to_string(solution.joint.steps) +
            " Newton steps on pressure and shear together";
  }
  return text + ", tol " + to_text(tol) + "; reached tangential_load = (" +
         to_short_text(shear.force[0], 6) + ", " + to_short_text(shear.force[1], 6) +
         ") N, torque = " + to_short_text(shear.force[2], 6) + " N m";
}

/// Message about an accepted solution that has not converged; empty: converged. Throws StalledError
/// for a solution that has not converged and is not accepted.
std::string require_solved(const PartialSlipSolution& solution, const Drive& drive,
                           const ContactSettings& settings) {
  const ShearSolution& shear = solution.tangential;
  const int iterations = solution.normal.iterations + shear.iterations;
  if (!is_finite(solution.normal) || !all_finite(shear.shear) || !all_finite(shear.slip)) {
    throw StalledError(
        "partial slip did not converge at " + describe(drive) + ": the solution is not finite",
        iterations, solution.normal.error);
  }
  if (solution.normal.converged) return {};
  const std::string where = describe(drive);
  const std::string text = describe_error(solution, settings.tol);
  const double error = std::max(shear.error, solution.normal.error);
  if (settings.after_stall == AfterStall::accept) {
    return "partial slip did not converge at " + where + ": " + text +
           ": the result is the state with the smallest error; reduce the force or increment, or "
           "increase tol";
  }
  const std::string message = "partial slip did not converge at " + where + ": " + text +
                              ": reduce the force or increment, increase tol, or set "
                              "on_stall=\"warn\" for the state with the smallest error";
  throw StalledError(message, iterations, error);
}

}  // namespace

void PartialSlipContact::require_contact(const Field& gap, const Drive& drive,
                                         const ContactHistory& before) const {
  require_gap(gap, grid_, "gap");
  if (!before.pressure.empty()) {
    require_surface(before.pressure, grid_, "previous.pressure");
    require_vectors(before.shear, grid_, "previous.shear");
    if (!before.gap.empty()) require_gap(before.gap, grid_, "previous.gap");
  }
  require_possible(grid_, *law_, gap, drive);
}

PartialSlipSolution PartialSlipContact::finished(PartialSlipSolution solution, const Drive& drive,
                                                 const Attraction& attraction,
                                                 const ContactSettings& settings) const {
  solution.stall_warning = require_solved(solution, drive, settings);
  Solution& pressed = solution.normal;
  pressed.edge_warning = edge_warning(grid_, pressed.tractions.pressure, describe(drive));
  if (!pressed.edge_warning.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, pressed.tractions.pressure, pressed.edge_warning);
  }
  pressed = attraction.with_attraction(std::move(pressed), drive);
  return solution;
}

/// Solution with the friction of the place, of the slip rate and of the plastic slip.
PartialSlipSolution PartialSlipContact::with_conditions(const SolveUnder& solve, Field pressure,
                                                        const PartialSlipStart& start,
                                                        const FrictionConditions& given,
                                                        const RateSettings& settings) const {
  const auto own = [&](bool rolls) { return self_influence(rolls); };
  if (const ThirdBody* layer = friction_.hardening()) {
    return solve_with_hardening(*layer, grid_, solve, std::move(pressure), start, given, settings,
                                own);
  }
  if (friction_.map() == nullptr && !friction_.rates().is_on()) {
    return solve(std::move(pressure), start, given);
  }
  FrictionConditions conditions = given;
  if (friction_.map() != nullptr && settings.rolls && friction_.map()->x.size() > 1) {
    throw std::invalid_argument(
        "x of the friction law must be empty in steady rolling: with friction that varies along "
        "the "
        "direction of rolling no state is steady; use a Simulation");
  }
  if (friction_.map() != nullptr && conditions.factor.empty()) {
    conditions.factor = factor_on(*friction_.map(), grid_, 0.0, 0.0);
  }
  if (!friction_.rates().is_on()) return solve(std::move(pressure), start, conditions);
  return solve_with_slip_rate(friction_.rates(), grid_, solve, std::move(pressure), start,
                              conditions, settings, own);
}

PartialSlipSolution PartialSlipContact::solve(const Field& gap, const Drive& drive,
                                              const TangentialDrive& tangential,
                                              const ContactHistory& before,
                                              const PartialSlipStart& start,
                                              const ContactSettings& settings,
                                              const FrictionConditions& conditions) const {
  const auto driven = [&](const TangentialDrive& by, const PartialSlipStart& from) {
    return solve_driven(gap, drive, by, before, from, settings, conditions);
  };
  return solve_pulled(friction_, grid_, tangential, driven, start, settings.tol);
}

PartialSlipSolution PartialSlipContact::solve_driven(const Field& gap, const Drive& drive,
                                                     const TangentialDrive& tangential,
                                                     const ContactHistory& before,
                                                     const PartialSlipStart& start,
                                                     const ContactSettings& settings,
                                                     const FrictionConditions& conditions) const {
  require_contact(gap, drive, before);
  if (!start.pressure.empty()) require_surface(start.pressure, grid_, "initial_pressure");
  if (adhesive_) {
    return AdhesiveSlip(*this, gap, drive, tangential, before, settings, conditions).run(start);
  }
  const Attraction attraction(*law_, grid_, normal_.displacement(), gap);
  const Drive repelling = attraction.repelling(drive);
  require_reach(repelling, grid_, gap);
  if (drive.normal.is_force()) {
    require_held(tangential, friction_, repelling.normal.value, increment_motions);
  }
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
  const auto run = [&](Field pressure, const PartialSlipStart& from,
                       const FrictionConditions& local) {
    Sweeps sweeps(*this, attraction.gap(), repelling, tangential, history, local, settings);
    return finished(sweeps.run(std::move(pressure), from), drive, attraction, settings);
  };
  return with_conditions(run, std::move(repulsion), start, conditions, {false, settings.tol});
}

PartialSlipSolution PartialSlipContact::roll(const Field& gap, const Drive& drive,
                                             const TangentialDrive& creepage,
                                             const PartialSlipStart& start,
                                             const ContactSettings& settings,
                                             const FrictionConditions& conditions,
                                             const Field& displacement) const {
  require_contact(gap, drive, {start.pressure, start.shear, {}});
  if (adhesive_) {
    throw std::invalid_argument(
        "adhesion that depends on the gap is not supported in steady rolling: use hard contact");
  }
  const Attraction attraction(*law_, grid_, normal_.displacement(), gap);
  const Drive repelling = attraction.repelling(drive);
  require_reach(repelling, grid_, gap);
  ContactHistory still;
  still.free_slip = displacement;
  for (double& slip : still.free_slip) slip = -slip;
  const auto driven = [&](const TangentialDrive& by, const PartialSlipStart& from) {
    if (drive.normal.is_force()) {
      require_held(by, friction_, repelling.normal.value, rolling_motions);
    }
    PartialSlipStart begin = from;
    begin.pressure = attraction.repulsion(std::move(begin.pressure));
    begin.pressure.resize(gap.size(), 0.0);
    // Without an initial shear, start from coarser boxes.
    if (!begin.shear.empty() && !(longest(begin.shear) > 0)) begin.shear.clear();
    const auto run = [&](Field pressure, const PartialSlipStart& near,
                         const FrictionConditions& local) {
      Sweeps sweeps(*this, attraction.gap(), repelling, by, still, local, settings, true);
      return finished(sweeps.run(std::move(pressure), near), drive, attraction, settings);
    };
    return with_conditions(run, begin.pressure, begin, conditions, {true, settings.tol});
  };
  return solve_pulled(friction_, grid_, creepage, driven, start, settings.tol);
}

}  // namespace samcontact::contact
