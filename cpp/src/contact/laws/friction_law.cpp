// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/laws/friction_law.hpp"

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

template <class Law>
double bound_of(const Law& law, double pressure) {
  return in_contact(pressure) ? law.bound(pressure) : 0.0;
}

}  // namespace

FrictionLaw::FrictionLaw(Laws law) : law_(law) {
  visit([](const auto& made) {
    std::decay_t<decltype(made)>::parameters(
        made, [](const char* name, double value, const Allowed& allowed) {
          require_allowed(name, value, allowed);
        });
  });
}

FrictionLaw FrictionLaw::named(const std::string& name, const Values& values) {
  Laws found;
  bool known = false;
  for_each_law<Laws>([&](auto law) {
    using Law = decltype(law);
    if (name != Law::name) return;
    known = true;
    Law::parameters(law, [&](const char* parameter, double& value, const Allowed&) {
      value = values.at(parameter);
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
    Law::parameters(law, [&](const char* name, double, const Allowed& allowed) {
      description.parameters.push_back({name, allowed});
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
  return slides() ? fft::Symmetry::y : fft::Symmetry::xy;
}

}  // namespace samcontact::contact
