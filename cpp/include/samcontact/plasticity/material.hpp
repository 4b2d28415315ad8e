// SPDX-License-Identifier: GPL-3.0-or-later
// Materials: isotropic elasticity; J2 plasticity with isotropic and kinematic hardening.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/plasticity/hardening.hpp"

namespace samcontact::plasticity {

/// Kinematic hardening: a backstress X, which moves the yield surface with the plastic strain e,
/// dX = 2/3 modulus de - recovery X dg (Armstrong & Frederick 1966; without recovery Prager 1949).
struct Backstress {
  double modulus = 0.0;   // [Pa]
  double recovery = 0.0;  // [-]

  bool operator==(const Backstress&) const = default;
};

/// As many may add up (Chaboche 1986).
constexpr int max_backstresses = 4;

struct Material {
  Elastic elastic;
  Hardening hardening;
  std::vector<Backstress> backstresses = {};
  std::optional<Thermal> thermal = {};

  /// Both throw std::invalid_argument naming the parameter, its value and what is allowed.
  static Material with_law(double E, double nu, Hardening::Laws law);
  static Material with_law(double E, double nu, const std::string& name,
                           const Hardening::Values& values);
  static Material make_elastic(double E, double nu) { return with_law(E, nu, NoYield{}); }
  static Material make_rigid();

  /// The same with kinematic hardening beside its isotropic hardening, instead of what it had.
  Material with_backstresses(const std::vector<Backstress>& terms) const;

  /// The same with thermal constants.
  Material with_thermal(const Thermal& constants) const;

  bool operator==(const Material&) const = default;
  bool is_plastic() const { return hardening.yields(); }
};

}  // namespace samcontact::plasticity
