// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/slip_rate.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {
namespace {

constexpr int max_rate_iterations = 200;
/// Tolerance of the relative coefficient: multiple of that of the contact, and minimum.
constexpr double rate_tol_ratio = 10, min_rate_tol = 1e-10;
/// Number of iterations without progress after which steps are halved, and the shortest step.
constexpr int rate_patience = 8;
constexpr double shortest_rate_step = 0.06;

/// Slip rates of the cells after an increment, and the derivative with respect to the slip of the
/// cell over the duration.
struct Rates {
  Field value, slope;
};

class SlipRate {
 public:
  SlipRate(const SlipRateLaw& law, const Grid& grid, const FrictionConditions& given, bool rolls)
      : law_(law), grid_(grid), given_(given), rolls_(rolls), before_(given.slip_rate) {
    before_.resize(grid.surface_size(), 0.0);
  }

  const Field& before() const { return before_; }

  /// Rates that follow from a slip.
  Rates of(const PartialSlipSolution& solution) const {
    const std::size_t n = grid_.surface_size();
    const Field &slip = solution.tangential.slip, &pressure = solution.normal.tractions.pressure;
    Rates rates{law_.memory > 0 ? before_ : Field(n, 0.0), Field(n, 0.0)};
    // Towards -x, so that a cell of rolling surfaces follows the cell from which it comes.
    for (std::size_t at = n; at-- > 0;) {
      if (!in_contact(pressure[at])) continue;
      const double length = length_of(slip[at], slip[n + at]), rate = length / given_.duration;
      rates.value[at] = rate;
      rates.slope[at] = 1.0;
      if (!(law_.memory > 0)) continue;
      const double way = (rolls_ ? grid_.dx : 1.0) * length;
      const double kept = std::exp(-way / law_.memory), entered = arriving(rates.value, at);
      rates.value[at] = kept * entered + (1 - kept) * rate;
      rates.slope[at] =
          1 - kept +
          (rate - entered) * kept * (rolls_ ? grid_.dx : 1.0) * given_.duration / law_.memory;
    }
    return rates;
  }

  /// Largest decrease of the bound of a cell with the displacement that a decrease of its own shear
  /// causes.
  double falling_number(const PartialSlipSolution& solution, const Rates& rates,
                        double self_influence, bool anywhere) const {
    const Field& pressure = solution.normal.tractions.pressure;
    const double cells = rolls_ ? 1 / (grid_.dx * given_.duration) : 1 / given_.duration;
    return self_influence * cells * largest_of(pressure.size(), [&](std::size_t at) {
             const double fall =
                 anywhere ? law_.fall(0.0) : law_.fall(rates.value[at]) * rates.slope[at];
             return std::max(pressure[at], 0.0) * std::fabs(fall);
           });
  }

 private:
  /// Slip rate with which the material of a cell arrives.
  double arriving(const Field& rates, std::size_t at) const {
    if (!rolls_) return before_[at];
    const std::size_t ahead = at + grid_.ny;
    return ahead < rates.size() ? rates[ahead] : 0.0;
  }

  const SlipRateLaw& law_;
  const Grid& grid_;
  const FrictionConditions& given_;
  const bool rolls_;
  Field before_;
};

void require_single(double number, const SlipRateLaw& law, const FrictionConditions& given,
                    bool rolls) {
  if (rolls || law.memory > 0 || given.selects || number <= 1) return;
  throw std::invalid_argument(
      "the falling number must be at most 1, got " + to_short_text(number, 4) +
      ": in such a short time cells may be able to stick as well as to slip; use a longer "
      "duration, a "
      "memory of the law, or choose the solution by the slip rate from which the iteration starts");
}

Field factors_of(const SlipRateLaw& law, const Field& rates) {
  Field factor(rates.size());
  for (std::size_t at = 0; at < rates.size(); ++at) factor[at] = law.factor(rates[at]);
  return factor;
}

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

Field factor_on(const MappedCoulomb& map, const Grid& grid, double moved) {
  const std::vector<double> x = grid.x(), y = grid.y();
  Field factor(grid.surface_size());
  for (std::size_t at = 0; at < factor.size(); ++at) {
    factor[at] = map.factor(x[at / grid.ny] + moved, y[at % grid.ny]);
  }
  return factor;
}

PartialSlipSolution solve_with_slip_rate(const SlipRateLaw& law, const Grid& grid,
                                         const SolveUnder& solve, Field pressure,
                                         const PartialSlipStart& start,
                                         const FrictionConditions& given,
                                         const RateSettings& settings,
                                         const std::function<double(bool)>& self_influence) {
  require(given.duration > 0, "duration", "> 0 [s] for friction that depends on the slip rate",
          given.duration);
  const double tol = std::max(rate_tol_ratio * settings.tol, min_rate_tol);
  const SlipRate slip_rate(law, grid, given, settings.rolls);
  FrictionConditions conditions = given;
  Field rate = slip_rate.before();
  PartialSlipStart from = start;
  PartialSlipSolution last;
  double change = 0.0, best = INFINITY, length = 1.0;
  for (int n = 1, stalled = 0; n <= max_rate_iterations; ++n) {
    conditions.factor = factors_of(law, rate);
    PartialSlipSolution found = solve(std::move(pressure), from, conditions);
    add_work(last, found);
    const Rates next = slip_rate.of(found);
    if (n == 1) {
      const double number =
          slip_rate.falling_number(found, next, self_influence(settings.rolls), true);
      require_single(number, law, given, settings.rolls);
    }
    const Field& pressed = found.normal.tractions.pressure;
    change = largest_of(rate.size(), [&](std::size_t at) {
      return in_contact(pressed[at]) ? std::fabs(law.factor(next.value[at]) - law.factor(rate[at]))
                                     : 0.0;
    });
    if (change <= tol || !found.stall_warning.empty()) {
      found.falling_number =
          slip_rate.falling_number(found, next, self_influence(settings.rolls), false);
      found.rate_iterations = n;
      found.slip_rate = next.value;
      return found;
    }
    stalled = change < 0.9 * best ? 0 : stalled + 1;
    best = std::min(best, change);
    if (stalled > rate_patience && length > shortest_rate_step) {
      length *= 0.5;
      stalled = 0;
    }
    for (std::size_t at = 0; at < rate.size(); ++at) {
      rate[at] += length * (next.value[at] - rate[at]);
    }
    pressure = pressed;
    for (double& p : pressure) p = std::max(p, 0.0);
    from = {{}, found.tangential.shear, found.tangential.sticking, found.tangential.motion, false};
    last = std::move(found);
  }
  throw ConvergenceError(
      "the slip rate of falling friction did not converge: the coefficient still "
      "changes by a fraction " +
          to_short_text(change) + " after " + std::to_string(max_rate_iterations) +
          " solves: use a longer duration, or a memory of the law",
      max_rate_iterations, change);
}

}  // namespace samcontact::contact
