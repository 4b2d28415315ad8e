// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/varying_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

constexpr int max_rate_iterations = 200;
/// Tolerance of the relative bound: multiple of that of the contact, and minimum.
constexpr double rate_tol_ratio = 10, min_rate_tol = 1e-10;
/// Number of iterations without progress after which steps are halved, and the shortest step.
constexpr int rate_patience = 8;
constexpr double shortest_rate_step = 0.06;

void add_work(const PartialSlipSolution& last, PartialSlipSolution& next) {
  next.normal.iterations += last.normal.iterations;
  next.normal.operator_applications += last.normal.operator_applications;
  next.normal.work += last.normal.work;
  next.tangential.steps += last.tangential.steps;
  next.tangential.iterations += last.tangential.iterations;
  next.tangential.fallbacks += last.tangential.fallbacks;
  next.tangential.operator_applications += last.tangential.operator_applications;
  next.tangential.work += last.tangential.work;
  next.joint.steps += last.joint.steps;
}

}  // namespace

PartialSlipSolution solve_with_bound(const VaryingBound& bound, const SolveUnder& solve,
                                     Field pressure, const PartialSlipStart& start,
                                     const FrictionConditions& given, double solution_tol) {
  const double tol = std::max(rate_tol_ratio * solution_tol, min_rate_tol);
  FrictionConditions conditions = given;
  Field quantity = bound.before();
  PartialSlipStart from = start;
  PartialSlipSolution last;
  double change = 0.0, best = INFINITY, length = 1.0;
  for (int n = 1, stalled = 0; n <= max_rate_iterations; ++n) {
    conditions.factor = bound.factors(quantity, pressure);
    PartialSlipSolution found = solve(std::move(pressure), from, conditions);
    add_work(last, found);
    Field next = bound.after(found);
    if (n == 1) bound.require_single(found);
    const Field& pressed = found.normal.tractions.pressure;
    const Field factor = bound.factors(next, pressed);
    change = largest_of(quantity.size(), [&](std::size_t at) {
      return in_contact(pressed[at]) ? std::fabs(factor[at] - conditions.factor[at]) : 0.0;
    });
    if (change <= tol || !found.stall_warning.empty()) {
      found.rate_iterations = n;
      bound.store(found, std::move(next));
      return found;
    }
    stalled = change < 0.9 * best ? 0 : stalled + 1;
    best = std::min(best, change);
    if (stalled > rate_patience && length > shortest_rate_step) {
      length *= 0.5;
      stalled = 0;
    }
    for (std::size_t at = 0; at < quantity.size(); ++at) {
      quantity[at] += length * bound.step(next[at], pressed[at]) * (next[at] - quantity[at]);
    }
    pressure = pressed;
    for (double& p : pressure) p = std::max(p, 0.0);
    from = {{}, found.tangential.shear, found.tangential.sticking, found.tangential.motion, false};
    last = std::move(found);
  }
  throw ConvergenceError(bound.quantity() + " did not converge: the bound still changes by a " +
                             "fraction " + to_short_text(change) + " after " +
                             std::to_string(max_rate_iterations) + " solves: " + bound.remedy(),
                         max_rate_iterations, change);
}

}  // namespace samcontact::contact
