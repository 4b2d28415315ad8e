// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/laws/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/law_parameters.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/adhesion.hpp"

namespace samcontact::contact {
namespace {

/// p >= -limit at any gap: an attraction of infinite range.
class TensileLimit final : public ContactLaw {
 public:
  explicit TensileLimit(double limit) : limit_(limit) {
    require(std::isfinite(limit) && limit >= 0, "limit", "a finite number >= 0", limit);
  }

  double attraction(double gap) const override { return std::isinf(gap) ? 0.0 : limit_; }
  double largest_attraction() const override { return limit_; }
  double energy(double gap) const override { return std::isinf(gap) ? 0.0 : limit_ * gap; }

 private:
  double limit_;  // [Pa]
};

/// A law whose friction depends on the compressive part of the pressure.
class RubbingByCompression final : public ContactLaw {
 public:
  explicit RubbingByCompression(SharedContactLaw law) : law_(std::move(law)) {}

  double attraction(double gap) const override { return law_->attraction(gap); }
  double largest_attraction() const override { return law_->largest_attraction(); }
  double fall(double gap) const override { return law_->fall(gap); }
  double steepest_fall() const override { return law_->steepest_fall(); }
  double reach() const override { return law_->reach(); }
  double energy(double gap) const override { return law_->energy(gap); }
  bool rubs_by_compression() const override { return true; }

 private:
  SharedContactLaw law_;
};

/// Error of the pressure relative to its maximum, at the loosest tolerance of an adhesive contact.
constexpr double error_fraction = 1e-5;

using Make = std::function<SharedContactLaw(const std::vector<double>& parameters)>;

const std::map<std::string, Make>& laws() {
  static const std::map<std::string, Make> laws{
      {"hard", [](const auto&) { return hard_contact(); }},
      {"tensile_limit",
       [](const auto& limit) { return std::make_shared<const TensileLimit>(limit.at(0)); }},
      {"exponential", [](const auto& p) { return exponential_adhesion(p.at(0), p.at(1)); }},
      {"dugdale", [](const auto& p) { return dugdale_adhesion(p.at(0), p.at(1), p.at(2)); }},
      {"lennard_jones", [](const auto& p) { return lennard_jones_adhesion(p.at(0), p.at(1)); }},
      {"tabulated", [](const auto& p) { return tabulated_adhesion(p); }},
  };
  return laws;
}

}  // namespace

SharedContactLaw hard_contact() {
  static const auto law = std::make_shared<const HardContact>();
  return law;
}

SharedContactLaw contact_law(const std::string& kind, const std::vector<double>& parameters) {
  const auto found = laws().find(kind);
  if (found == laws().end()) {
    std::vector<std::string> names;
    for (const auto& [name, make] : laws()) names.push_back(name);
    throw unknown_law("contact law", names, kind);
  }
  return found->second(parameters);
}

SharedContactLaw rubbing_by_compression(SharedContactLaw law) {
  return std::make_shared<const RubbingByCompression>(std::move(law));
}

Field attraction(const ContactLaw& law, const Field& gap) {
  Field pull(gap.size());
  for (std::size_t i = 0; i < gap.size(); ++i) pull[i] = law.attraction(gap[i]);
  return pull;
}

Field repulsion(const ContactLaw& law, Field pressure, const Field& gap) {
  if (!law.attracts()) return pressure;
  for (std::size_t i = 0; i < pressure.size(); ++i) pressure[i] += law.attraction(gap[i]);
  if (!law.varies()) return pressure;
  const double largest =
      std::max(law.largest_attraction(),
               largest_of(pressure.size(), [&](std::size_t i) { return pressure[i]; }));
  for (double& r : pressure) r = r > error_fraction * largest ? r : 0.0;
  return pressure;
}

Field rubbing_pressure(const ContactLaw& law, Field pushed, const Field& gap) {
  if (!law.rubs_by_compression()) return pushed;
  for (std::size_t i = 0; i < pushed.size(); ++i) {
    if (in_contact(pushed[i])) pushed[i] = std::max(pushed[i] - law.attraction(gap[i]), 0.0);
  }
  return pushed;
}

}  // namespace samcontact::contact
