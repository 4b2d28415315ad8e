// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/material.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "samcontact/base/errors.hpp"

namespace samcontact::plasticity {
namespace {

constexpr double micro = 1e6;  // Swift's strains are in microstrain

void require_positive(const char* name, double value, const char* allowed) {
  require(std::isfinite(value) && value > 0, name, allowed, value);
}

}  // namespace

Hardening Hardening::linear(double yield_stress, double modulus) {
  Hardening h;
  h.law_ = Law::linear;
  h.initial_ = yield_stress;
  h.modulus_ = modulus;
  return h;
}

Hardening Hardening::swift(double B, double C, double n) {
  Hardening h;
  h.law_ = Law::swift;
  h.B_ = B;
  h.C_ = C;
  h.n_ = n;
  return h;
}

Hardening::Point Hardening::at(double g) const {
  switch (law_) {
    case Law::linear:
      return {initial_ + modulus_ * g, modulus_};
    case Law::swift: {
      const double base = C_ + micro * g, stress = B_ * std::pow(base, n_);
      return {stress, n_ * micro * stress / base};
    }
    default:
      return {std::numeric_limits<double>::infinity(), 0.0};
  }
}

Hardening Hardening::scaled(double factor) const {
  Hardening law = *this;
  law.initial_ *= factor;
  law.modulus_ *= factor;
  law.B_ *= factor;
  return law;
}

double Hardening::yield_stress(double g) const { return at(g).yield_stress; }
double Hardening::slope(double g) const { return at(g).slope; }

Material Material::make_elastic(double E, double nu) { return {Elastic::isotropic(E, nu)}; }

Material Material::make_rigid() { return {Elastic::rigid()}; }

Material Material::make_perfect_plastic(double E, double nu, double yield_stress) {
  const Elastic elastic = Elastic::isotropic(E, nu);
  require_positive("yield_stress", yield_stress, "a finite number > 0 [Pa]");
  return {elastic, Hardening::linear(yield_stress, 0.0)};
}

Material Material::make_linear_hardening(double E, double nu, double yield_stress,
                                         double tangent_modulus) {
  const Elastic elastic = Elastic::isotropic(E, nu);
  require_positive("yield_stress", yield_stress, "a finite number > 0 [Pa]");
  require(tangent_modulus >= 0 && tangent_modulus < E, "tangent_modulus",
          "in [0, E) with E = " + to_text(E) + " Pa", tangent_modulus);
  return {elastic, Hardening::linear(yield_stress, E * tangent_modulus / (E - tangent_modulus))};
}

Material Material::make_swift(double E, double nu, double B, double C, double n) {
  const Elastic elastic = Elastic::isotropic(E, nu);
  require_positive("B", B, "a finite number > 0 [Pa]");
  require_positive("C", C, "a finite number > 0 [microstrain]");
  require(n >= 0 && n <= 1, "n", "in [0, 1]", n);
  return {elastic, Hardening::swift(B, C, n)};
}

Material Material::with_backstresses(const std::vector<Backstress>& terms) const {
  if (!is_plastic()) {
    throw std::invalid_argument("kinematic hardening needs a body that yields, not an elastic one");
  }
  const auto count = static_cast<double>(terms.size());
  require(count >= 1 && count <= max_backstresses, "number of backstresses",
          "from 1 to " + std::to_string(max_backstresses), count);
  for (const Backstress& term : terms) {
    require_positive("modulus", term.modulus, "a finite number > 0 [Pa]");
    require(std::isfinite(term.recovery) && term.recovery >= 0, "recovery", "a finite number >= 0",
            term.recovery);
  }
  Material material = *this;
  material.backstresses = terms;
  return material;
}

Material Material::with_thermal(const Thermal& constants) const {
  if (elastic.is_rigid()) {
    throw std::invalid_argument("a rigid body does not expand: it has no thermal constants");
  }
  Material material = *this;
  material.thermal = constants;
  return material;
}

}  // namespace samcontact::plasticity
