// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/laws/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

template <class Law>
double bound_of(const Law& law, double pressure) {
  return in_contact(pressure) ? law.bound(pressure) : 0.0;
}

}  // namespace

namespace {

void require_increasing(const std::string& axis, const std::vector<double>& points) {
  for (std::size_t n = 1; n < points.size(); ++n) {
    require(points[n] > points[n - 1], entry(axis, n), "larger than " + entry(axis, n - 1),
            points[n]);
  }
}

}  // namespace

void MappedCoulomb::check() const {
  require_increasing("x", x);
  require_increasing("y", y);
  const std::size_t count = std::max<std::size_t>(x.size(), 1) * std::max<std::size_t>(y.size(), 1);
  if (coefficient.size() != count) {
    throw std::invalid_argument("x, y must define as many points as coefficient has values, " +
                                std::to_string(coefficient.size()) + ", got " +
                                std::to_string(count));
  }
  require(body == 1 || body == 2, "body", "1 or 2", body);
}

double MappedCoulomb::largest() const {
  return coefficient.empty() ? 0.0 : *std::max_element(coefficient.begin(), coefficient.end());
}

namespace {

/// Index of the first of two neighbouring points, and the weight of the second.
std::pair<std::size_t, double> between(const std::vector<double>& points, double at) {
  if (points.size() < 2 || at <= points.front()) return {0, 0.0};
  if (at >= points.back()) return {points.size() - 2, 1.0};
  const auto next = std::upper_bound(points.begin(), points.end(), at);
  const auto n = static_cast<std::size_t>(next - points.begin()) - 1;
  return {n, (at - points[n]) / (points[n + 1] - points[n])};
}

}  // namespace

double MappedCoulomb::factor(double at_x, double at_y) const {
  const auto [i, u] = between(x, at_x);
  const auto [j, v] = between(y, at_y);
  const std::size_t width = std::max<std::size_t>(y.size(), 1);
  const auto value = [&](std::size_t k, std::size_t l) { return coefficient[k * width + l]; };
  const auto along_y = [&, j = j, v = v](std::size_t k) {
    return v > 0 ? (1 - v) * value(k, j) + v * value(k, j + 1) : value(k, j);
  };
  const double mu = u > 0 ? (1 - u) * along_y(i) + u * along_y(i + 1) : along_y(i);
  const double most = largest();
  return most > 0 ? mu / most : 1.0;
}

void ThirdBody::check() const {
  if (hardening == 0 || std::isfinite(strength)) return;
  throw std::invalid_argument("hardening must be 0 with infinite strength, got " +
                              to_text(hardening) + ": a layer that never yields does not harden");
}

void ThermalCoulomb::check() const {
  require_increasing("temperature", temperature);
  if (temperature.empty() || coefficient.size() != temperature.size()) {
    throw std::invalid_argument("coefficient must have one value for each temperature, " +
                                std::to_string(temperature.size()) + ", got " +
                                std::to_string(coefficient.size()));
  }
}

double ThermalCoulomb::largest() const {
  return coefficient.empty() ? 0.0 : *std::max_element(coefficient.begin(), coefficient.end());
}

double ThermalCoulomb::factor(double rise) const {
  const auto [n, weight] = between(temperature, bulk + rise);
  const double mu =
      weight > 0 ? (1 - weight) * coefficient[n] + weight * coefficient[n + 1] : coefficient[n];
  const double most = largest();
  return most > 0 ? mu / most : 1.0;
}

FrictionLaw::FrictionLaw(Laws law) : law_(std::move(law)) {
  visit([](const auto& made) {
    std::decay_t<decltype(made)>::parameters(
        made, [](const char* name, const auto& value, const Allowed& allowed) {
          require_allowed(name, value, allowed);
        });
    if constexpr (requires { made.check(); }) made.check();
  });
}

FrictionLaw FrictionLaw::named(const std::string& name, const Values& values) {
  Laws found;
  bool known = false;
  for_each_law<Laws>([&](auto law) {
    using Law = decltype(law);
    if (name != Law::name) return;
    known = true;
    Law::parameters(law, [&](const char* parameter, auto& value, const Allowed&) {
      const std::vector<double>& given = values.at(parameter);
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
        value = given.at(0);
      } else {
        value = given;
      }
    });
    found = law;
  });
  if (!known) throw unknown_law("friction law", law_names<Laws>(), name);
  return FrictionLaw(found);
}

std::vector<FrictionDescription> FrictionLaw::descriptions() {
  std::vector<FrictionDescription> all;
  for_each_law<Laws>([&](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    FrictionDescription description{Law::name, Law::says, Law::sticks, {}};
    Law::parameters(law, [&](const char* name, const auto& value, const Allowed& allowed) {
      constexpr bool many = !std::is_same_v<std::decay_t<decltype(value)>, double>;
      description.parameters.push_back({name, allowed, many});
    });
    all.push_back(std::move(description));
  });
  return all;
}

bool FrictionLaw::sticks() const {
  return visit([](const auto& law) { return law.sticks; });
}

double FrictionLaw::bound(double pressure) const {
  return visit([pressure](const auto& law) { return bound_of(law, pressure); });
}

Field FrictionLaw::bound(Field pressure) const {
  visit([&](const auto& law) {
    for (double& value : pressure) value = bound_of(law, value);
  });
  return pressure;
}

double FrictionLaw::ratio(double pressure) const {
  return visit([pressure](const auto& law) { return law.ratio(pressure); });
}

Stretch FrictionLaw::stretch() const {
  return visit([](const auto& law) {
    if constexpr (requires { law.stretch(); }) {
      return law.stretch();
    } else {
      return Stretch{};
    }
  });
}

double FrictionLaw::compliance() const {
  return visit([](const auto& law) {
    if constexpr (requires { law.compliance(); }) {
      return law.compliance();
    } else {
      return 0.0;
    }
  });
}

SlipRateLaw FrictionLaw::rates() const {
  return visit([](const auto& law) {
    if constexpr (requires { law.rates(); }) {
      return law.rates();
    } else {
      return SlipRateLaw{};
    }
  });
}

bool FrictionLaw::prevents_slip() const { return std::isinf(bound(1.0)); }

double FrictionLaw::shear_over_pressure(int body) const {
  return sticks() ? 0.0 : operators::shear_sign(body) * ratio(0.0);
}

operators::Tractions FrictionLaw::tractions(Field pressure) const {
  operators::Tractions tractions{std::move(pressure), {}, {}};
  if (!slides()) return tractions;
  tractions.shear_x = tractions.pressure;
  const double ratio = shear_over_pressure(1);
  for (double& s : tractions.shear_x) s *= ratio;
  return tractions;
}

fft::Symmetry FrictionLaw::symmetry() const {
  if (stretch().is_turned() || map() != nullptr) return fft::Symmetry::none;
  return slides() ? fft::Symmetry::y : fft::Symmetry::xy;
}

}  // namespace samcontact::contact
