// SPDX-License-Identifier: GPL-3.0-or-later
// Materials: isotropic elasticity; J2 plasticity with isotropic and kinematic hardening.
#pragma once

#include <optional>
#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/thermal.hpp"

namespace samcontact::plasticity {

/// Yield stress [Pa] as a function of the equivalent plastic strain g [-].
class Hardening {
 public:
  enum class Law { elastic, linear, swift };

  /// Never yields.
  static Hardening none() { return {}; }
  /// yield_stress + modulus g; modulus 0 is perfect plasticity.
  static Hardening linear(double yield_stress, double modulus);
  /// B (C + 1e6 g)^n, B in Pa: Swift's law, whose C counts microstrain.
  static Hardening swift(double B, double C, double n);

  Law law() const { return law_; }
  double yield_stress(double g) const;
  /// d yield_stress / dg [Pa].
  double slope(double g) const;
  /// Both at once: a power costs more than all else here.
  struct Point {
    double yield_stress, slope;
  };
  Point at(double g) const;
  /// Law whose yield stress is `factor` times this one's.
  Hardening scaled(double factor) const;

  bool operator==(const Hardening&) const = default;

 private:
  Law law_ = Law::elastic;
  double initial_ = 0.0, modulus_ = 0.0;
  double B_ = 0.0, C_ = 0.0, n_ = 0.0;
};

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
  Hardening hardening = Hardening::none();
  std::vector<Backstress> backstresses = {};
  std::optional<Thermal> thermal = {};

  /// Factories throw std::invalid_argument naming the parameter, its value and what is allowed.
  static Material make_elastic(double E, double nu);
  static Material make_rigid();
  static Material make_perfect_plastic(double E, double nu, double yield_stress);
  /// tangent_modulus Et of the uniaxial curve, 0 <= Et < E; the hardening modulus is E Et/(E - Et).
  static Material make_linear_hardening(double E, double nu, double yield_stress,
                                        double tangent_modulus);
  static Material make_swift(double E, double nu, double B, double C, double n);

  /// The same with kinematic hardening beside its isotropic hardening, instead of what it had.
  Material with_backstresses(const std::vector<Backstress>& terms) const;

  /// The same with thermal constants.
  Material with_thermal(const Thermal& constants) const;

  bool operator==(const Material&) const = default;
  bool is_plastic() const { return hardening.law() != Hardening::Law::elastic; }
};

}  // namespace samcontact::plasticity
