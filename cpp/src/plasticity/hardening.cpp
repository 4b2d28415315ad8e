// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/hardening.hpp"

#include <algorithm>
#include <type_traits>

#include "samcontact/base/errors.hpp"

namespace samcontact::plasticity {
namespace {

/// x - 1 + e^-x for x >= 0, without cancellation where x is small.
double rest_of_exponential(double x) {
  if (x > 1) return x + std::expm1(-x);
  double term = 0.5 * x * x, sum = 0.0;
  for (int n = 3; std::fabs(term) > 1e-18 * sum; ++n) {
    sum += term;
    term *= -x / n;
  }
  return sum;
}

}  // namespace

void LinearHardening::prepare(const Elastic& elastic) {
  const double E = elastic.E;
  require(tangent_modulus < E, "tangent_modulus", "in [0, E) with E = " + to_text(E) + " Pa",
          tangent_modulus);
  modulus = E * tangent_modulus / (E - tangent_modulus);
}

double Swift::work(double g) const {
  // s^(n+1) (1 - (C/s)^(n+1)) with s = C + 1e6 g, without cancellation where g is small
  const double power = n + 1, s = C + micro * g;
  const double part =
      std::min(micro * g / s, 1 - 0x1p-53);  // 1: C is negligible compared with the strain
  const double grown = -std::expm1(power * std::log1p(-part));
  return B * std::pow(s, n) * (s * grown / (micro * power));
}

void Voce::prepare(const Elastic&) const {
  require(saturation_stress >= yield_stress, "saturation_stress",
          ">= yield_stress = " + to_text(yield_stress) + " Pa", saturation_stress);
}

double Voce::work(double g) const {
  const double range = saturation_stress - yield_stress;
  return yield_stress * g + range * (rest_of_exponential(rate * g) / rate);
}

void Tabulated::prepare(const Elastic&) {
  const std::size_t count = plastic_strain.size();
  require(count >= 1 && count <= max_points, "number of values in plastic_strain",
          "from 1 to " + std::to_string(max_points), static_cast<double>(count));
  require(stress.size() == count, "number of values in stress",
          "the number of values in plastic_strain, " + std::to_string(count),
          static_cast<double>(stress.size()));
  require(plastic_strain[0] == 0, "plastic_strain[0]",
          "0, the strain at first yield (plastic strain is total strain - stress/E)",
          plastic_strain[0]);
  slopes.assign(count, 0.0);
  works.assign(count, 0.0);
  for (std::size_t n = 1; n < count; ++n) {
    const std::string strain = entry("plastic_strain", n), last = entry("plastic_strain", n - 1);
    const double step = plastic_strain[n] - plastic_strain[n - 1];
    require(step > 0, strain, "> " + last + " = " + to_text(plastic_strain[n - 1]),
            plastic_strain[n], "specify one stress for each strain");
    require(stress[n] >= stress[n - 1], entry("stress", n),
            ">= " + entry("stress", n - 1) + " = " + to_text(stress[n - 1]) + " Pa", stress[n],
            "a falling curve has no unique solution");
    slopes[n - 1] = (stress[n] - stress[n - 1]) / step;
    require(std::isfinite(slopes[n - 1]), strain, "farther from " + last, plastic_strain[n],
            "the slope between them overflows");
    works[n] = works[n - 1] + 0.5 * (stress[n - 1] + stress[n]) * step;
  }
}

double Tabulated::work(double g) const {
  const std::size_t n = piece_at(g);
  const double part = g - plastic_strain[n];
  return works[n] + (stress[n] + 0.5 * slopes[n] * part) * part;
}

Hardening::Hardening(Laws law, const Elastic& elastic) : law_(std::move(law)) {
  std::visit(
      [&](auto& made) {
        std::decay_t<decltype(made)>::parameters(
            made, [](const char* name, const auto& value, const Allowed& allowed) {
              require_allowed(name, value, allowed);
            });
        made.prepare(elastic);
      },
      law_);
}

Hardening Hardening::named(const std::string& name, const Values& values, const Elastic& elastic) {
  Laws found;
  bool known = false;
  for_each_law<Laws>([&](auto law) {
    using Law = decltype(law);
    if (name != Law::name) return;
    known = true;
    Law::parameters(law, [&](const char* parameter, auto& value, const Allowed&) {
      const std::vector<double>& given = values.at(parameter);
      if constexpr (std::is_same_v<decltype(value), double&>) {
        value = given.at(0);
      } else {
        value = given;
      }
    });
    found = std::move(law);
  });
  if (!known) throw unknown_law("hardening law", law_names<Laws>(), name);
  return {std::move(found), elastic};
}

std::vector<LawDescription> Hardening::descriptions() {
  std::vector<LawDescription> all;
  for_each_law<Laws>([&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    LawDescription description{Law::name, Law::says, !std::is_same_v<Law, NoYield>, {}};
    Law::parameters(law, [&](const char* name, const auto& value, const Allowed& allowed) {
      description.parameters.push_back(
          {name, allowed, !std::is_same_v<decltype(value), const double&>});
    });
    all.push_back(std::move(description));
  });
  return all;
}

}  // namespace samcontact::plasticity
