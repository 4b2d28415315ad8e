// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/layer_hardening.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"
#include "samcontact/contact/varying_bound.hpp"

namespace samcontact::contact {
namespace {

/// Ratio of the strength to mu p from which a cell slips on the layer.
constexpr double on_layer = 1 - 1e-9;

class LayerHardening : public VaryingBound {
 public:
  LayerHardening(const ThirdBody& law, const Grid& grid, const FrictionConditions& given,
                 bool rolls, const std::function<double(bool)>& self_influence)
      : law_(law),
        grid_(grid),
        rolls_(rolls),
        self_influence_(self_influence),
        before_(rolls ? Field{} : given.plastic_slip) {
    before_.resize(grid.surface_size(), 0.0);
  }

  const Field& before() const override { return before_; }

  Field after(const PartialSlipSolution& solution) const override {
    const std::size_t n = grid_.surface_size();
    const Field &slip = solution.tangential.slip, &pressure = solution.normal.tractions.pressure;
    Field plastic = before_;
    // Towards -x, so that a cell of rolling surfaces follows the cell from which it comes.
    for (std::size_t at = n; at-- > 0;) {
      const double entered = arriving(plastic, at);
      plastic[at] = entered;
      if (!in_contact(pressure[at])) continue;
      const double way = (rolls_ ? grid_.dx : 1.0) * length_of(slip[at], slip[n + at]);
      plastic[at] += law_.plastic_part(way, entered, pressure[at]);
    }
    return plastic;
  }

  Field factors(const Field& plastic, const Field& pressure) const override {
    Field factor(plastic.size(), 1.0);
    for (std::size_t at = 0; at < plastic.size(); ++at) {
      const double bound = law_.bound(pressure[at]);
      if (in_contact(pressure[at]) && bound > 0) {
        factor[at] = std::min(1.0, law_.strength_after(plastic[at]) / bound);
      }
    }
    return factor;
  }

  void require_single(const PartialSlipSolution&) const override {
    const double number = -law_.hardening * self_influence_(rolls_);
    if (number < 1) return;
    throw std::invalid_argument(
        "hardening of the layer must be more than " +
        to_short_text(-1 / self_influence_(rolls_), 4) +
        " Pa/m on this grid, -1 divided by the displacement of a cell under its own unit shear, "
        "got " +
        to_text(law_.hardening) +
        ": a layer that softens so fast may flow suddenly, so that the increment has several "
        "solutions; use smaller cells, or a stiffer layer");
  }

  /// Newton's step for a cell whose shear follows its strength; the plastic slip of a cell that
  /// slips on the layer does not depend on the strength.
  double step(double plastic, double pressure) const override {
    const bool flows = law_.strength_after(plastic) < on_layer * law_.coefficient * pressure;
    return flows ? 1 / (1 + std::max(law_.hardening, 0.0) * self_influence_(rolls_)) : 1.0;
  }

  void store(PartialSlipSolution& solution, Field plastic) const override {
    solution.plastic_slip = std::move(plastic);
  }

  std::string quantity() const override { return "the plastic slip of the layer"; }
  std::string remedy() const override { return "use smaller increments"; }

 private:
  /// Plastic slip with which the layer of a cell arrives.
  double arriving(const Field& plastic, std::size_t at) const {
    if (!rolls_) return before_[at];
    const std::size_t ahead = at + grid_.ny;
    return ahead < plastic.size() ? plastic[ahead] : 0.0;
  }

  const ThirdBody& law_;
  const Grid& grid_;
  const bool rolls_;
  const std::function<double(bool)>& self_influence_;
  Field before_;
};

}  // namespace

PartialSlipSolution solve_with_hardening(const ThirdBody& law, const Grid& grid,
                                         const SolveUnder& solve, Field pressure,
                                         const PartialSlipStart& start,
                                         const FrictionConditions& given,
                                         const RateSettings& settings,
                                         const std::function<double(bool)>& self_influence) {
  return solve_with_bound(LayerHardening(law, grid, given, settings.rolls, self_influence), solve,
                          std::move(pressure), start, given, settings.tol);
}

}  // namespace samcontact::contact
