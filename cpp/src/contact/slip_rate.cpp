// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/slip_rate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"
#include "samcontact/contact/varying_bound.hpp"

namespace samcontact::contact {
namespace {

/// Slip rates of the cells after an increment, and the derivative with respect to the slip of the
/// cell over the duration.
struct Rates {
  Field value, slope;
};

class SlipRate : public VaryingBound {
 public:
  SlipRate(const SlipRateLaw& law, const Grid& grid, const FrictionConditions& given, bool rolls,
           const std::function<double(bool)>& self_influence)
      : law_(law),
        grid_(grid),
        given_(given),
        rolls_(rolls),
        self_influence_(self_influence),
        before_(given.slip_rate) {
    before_.resize(grid.surface_size(), 0.0);
  }

  const Field& before() const override { return before_; }

  Field after(const PartialSlipSolution& solution) const override { return of(solution).value; }

  Field factors(const Field& rates, const Field&) const override {
    Field factor(rates.size());
    for (std::size_t at = 0; at < rates.size(); ++at) factor[at] = law_.factor(rates[at]);
    return factor;
  }

  void require_single(const PartialSlipSolution& first) const override {
    const double number = falling_number(first, of(first), true);
    if (rolls_ || law_.memory > 0 || given_.selects || number <= 1) return;
    throw std::invalid_argument(
        "the falling number must be at most 1, got " + to_short_text(number, 4) +
        ": in such a short time cells may be able to stick as well as to slip; use a longer "
        "duration, a "
        "memory of the law, or choose the solution by the slip rate from which the iteration "
        "starts");
  }

  double step(double, double) const override { return 1.0; }

  void store(PartialSlipSolution& solution, Field rates) const override {
    solution.falling_number = falling_number(solution, of(solution), false);
    solution.slip_rate = std::move(rates);
  }

  std::string quantity() const override { return "the slip rate of falling friction"; }
  std::string remedy() const override { return "use a longer duration, or a memory of the law"; }

 private:
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
                        bool anywhere) const {
    const Field& pressure = solution.normal.tractions.pressure;
    const double cells = rolls_ ? 1 / (grid_.dx * given_.duration) : 1 / given_.duration;
    return self_influence_(rolls_) * cells * largest_of(pressure.size(), [&](std::size_t at) {
             const double fall =
                 anywhere ? law_.fall(0.0) : law_.fall(rates.value[at]) * rates.slope[at];
             return std::max(pressure[at], 0.0) * std::fabs(fall);
           });
  }

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
  const std::function<double(bool)>& self_influence_;
  Field before_;
};

}  // namespace

Field factor_on(const MappedCoulomb& map, const Grid& grid, double moved_x, double moved_y) {
  const std::vector<double> x = grid.x(), y = grid.y();
  Field factor(grid.surface_size());
  for (std::size_t at = 0; at < factor.size(); ++at) {
    factor[at] = map.factor(x[at / grid.ny] + moved_x, y[at % grid.ny] + moved_y);
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
  return solve_with_bound(SlipRate(law, grid, given, settings.rolls, self_influence), solve,
                          std::move(pressure), start, given, settings.tol);
}

}  // namespace samcontact::contact
