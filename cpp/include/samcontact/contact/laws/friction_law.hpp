// SPDX-License-Identifier: GPL-3.0-or-later
// Friction laws: maximum shear of a cell as a function of its pressure.
//
// Each law is a struct here and an alternative of FrictionLaw::Laws. The struct declares its name,
// its parameters and their ranges; checks, bindings and case files read them from there.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "samcontact/base/law_parameters.hpp"
#include "samcontact/contact/laws/stretch.hpp"
#include "samcontact/fft/mirrored_transform.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::contact {

/// Dependence of a coefficient of friction on the slip rate.
struct SlipRateLaw {
  double kinetic = 0.0, drop = 0.0;  // [-]
  double half_speed = 1.0;           // [m/s]
  double memory = 0.0;               // slip distance over which rates are averaged [m]; 0: none

  bool is_on() const { return drop > 0; }
  /// Coefficient at a slip rate [m/s].
  double coefficient(double rate) const { return kinetic + drop * std::exp2(-rate / half_speed); }
  /// Coefficient relative to that without slip.
  double factor(double rate) const { return coefficient(rate) / (kinetic + drop); }
  /// Decrease of the coefficient with the slip rate [s/m].
  double fall(double rate) const {
    return drop * std::numbers::ln2 / half_speed * std::exp2(-rate / half_speed);
  }
};

/// Body 1 slides over body 2 towards +x everywhere: the shear is mu p and is not an unknown.
struct FullSliding {
  static constexpr auto name = "gross_sliding",
                        says = "Full sliding along x with the shear stress mu p.";
  static constexpr bool sticks = false;
  double coefficient;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("coefficient", law.coefficient, Allowed{""});
  }
  double bound(double pressure) const { return coefficient * pressure; }
  double ratio(double) const { return coefficient; }
  bool operator==(const FullSliding&) const = default;
};

/// Shear of at most mu p.
struct Coulomb {
  static constexpr auto name = "coulomb", says = "Coulomb friction: shear stress of at most mu p.";
  static constexpr bool sticks = true;
  double coefficient;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("coefficient", law.coefficient, Allowed{.unit = "", .infinite = "no slip"});
  }
  double bound(double pressure) const { return coefficient * pressure; }
  double ratio(double) const { return coefficient; }
  bool operator==(const Coulomb&) const = default;
};

/// Shear of at most k at any pressure.
struct Tresca {
  static constexpr auto name = "tresca",
                        says = "Tresca friction: shear stress of at most k at any pressure.";
  static constexpr bool sticks = true;
  double limit;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("limit", law.limit, Allowed{.unit = "Pa", .infinite = "no slip"});
  }
  double bound(double) const { return limit; }
  double ratio(double pressure) const { return limit > 0 ? limit / pressure : 0.0; }
  bool operator==(const Tresca&) const = default;
};

/// Shear of at most mu p and at most k.
struct CappedCoulomb {
  static constexpr auto name = "capped_coulomb",
                        says =
                            "Capped Coulomb friction: shear stress of at most mu p and at most k.";
  static constexpr bool sticks = true;
  double coefficient, limit;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("coefficient", law.coefficient, Allowed{""});
    visit("limit", law.limit, Allowed{.unit = "Pa", .infinite = "Coulomb friction"});
  }
  double bound(double pressure) const { return std::min(coefficient * pressure, limit); }
  double ratio(double pressure) const {
    return limit > 0 ? std::min(coefficient, limit / pressure) : 0.0;
  }
  bool operator==(const CappedCoulomb&) const = default;
};

/// Elastic layer of wear particles between the bodies, which yields at a shear strength; the shear
/// is at most mu p. The strength increases with the plastic slip of the layer, or decreases.
struct ThirdBody {
  static constexpr auto name = "third_body",
                        says = "Elastic layer between the bodies that yields at a shear strength.";
  static constexpr bool sticks = true;
  double coefficient, strength, shear_modulus, thickness, hardening;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("coefficient", law.coefficient, Allowed{""});
    visit("strength", law.strength, Allowed{.unit = "Pa", .infinite = "an elastic layer"});
    visit("shear_modulus", law.shear_modulus, Allowed::positive("Pa"));
    visit("thickness", law.thickness, Allowed{"m"});
    visit("hardening", law.hardening,
          Allowed{.unit = "Pa/m", .low = -std::numeric_limits<double>::infinity()});
  }
  /// Throws std::invalid_argument for a hardening of a layer that never yields.
  void check() const;
  /// Maximum shear at any plastic slip.
  double bound(double pressure) const { return std::min(coefficient * pressure, limit()); }
  double ratio(double pressure) const {
    return limit() > 0 ? std::min(coefficient, limit() / pressure) : 0.0;
  }
  double limit() const {
    return hardening > 0 ? std::numeric_limits<double>::infinity() : strength;
  }
  bool hardens() const { return hardening != 0; }
  /// Strength after a plastic slip [m].
  double strength_after(double plastic) const {
    return std::max(strength + hardening * plastic, 0.0);
  }
  /// Part of a slip by which the layer flows [m]; it slips on its surface where its strength is
  /// above mu p. plastic: plastic slip before.
  double plastic_part(double slip, double plastic, double pressure) const {
    const double reserve = coefficient * pressure - strength_after(plastic);
    if (!(reserve > 0)) return 0.0;
    return hardening > 0 ? std::min(slip, reserve / hardening) : slip;
  }
  double compliance() const { return thickness / shear_modulus; }
  bool operator==(const ThirdBody&) const = default;
};

/// Shear s in an ellipse with the half-axes mu_x p and mu_y p; slip along the normal of the
/// ellipse.
struct Anisotropic {
  static constexpr auto name = "anisotropic",
                        says = "Anisotropic friction: shear stress within an ellipse.";
  static constexpr bool sticks = true;
  double mu_x, mu_y, angle;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("mu_x", law.mu_x, Allowed::positive(""));
    visit("mu_y", law.mu_y, Allowed::positive(""));
    visit("angle", law.angle,
          Allowed{.unit = "rad", .low = -std::numbers::pi, .high = std::numbers::pi});
  }
  double bound(double pressure) const { return std::max(mu_x, mu_y) * pressure; }
  double ratio(double) const { return std::max(mu_x, mu_y); }
  Stretch stretch() const { return Stretch::ellipse(mu_x, mu_y, angle); }
  bool operator==(const Anisotropic&) const = default;
};

/// Coulomb friction with a coefficient that varies over the surface of a body: bilinear between the
/// points (x, y), constant beyond them.
struct MappedCoulomb {
  static constexpr auto name = "mapped_coulomb",
                        says = "Coulomb friction with a coefficient that depends on the place.";
  static constexpr bool sticks = true;
  std::vector<double> coefficient;  // [x][y]
  std::vector<double> x, y;         // empty: no variation along this axis
  double body;                      // 1 or 2

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("coefficient", law.coefficient, Allowed{""});
    visit("x", law.x, Allowed{.unit = "m", .low = -std::numeric_limits<double>::infinity()});
    visit("y", law.y, Allowed{.unit = "m", .low = -std::numeric_limits<double>::infinity()});
    visit("body", law.body, Allowed{.unit = "", .low = 1, .high = 2});
  }
  /// Throws std::invalid_argument for points that do not increase or do not match the coefficients.
  void check() const;
  double largest() const;
  double bound(double pressure) const { return largest() * pressure; }
  double ratio(double) const { return largest(); }
  /// Coefficient at a point of the body, relative to the largest.
  double factor(double at_x, double at_y) const;
  bool operator==(const MappedCoulomb&) const = default;
};

/// Coulomb friction with a coefficient that depends on the temperature rise of the surfaces: linear
/// between points, constant beyond them.
struct ThermalCoulomb {
  static constexpr auto name = "thermal_coulomb",
                        says = "Coulomb friction with a coefficient that depends on temperature.";
  static constexpr bool sticks = true;
  std::vector<double> temperature, coefficient;
  double bulk;  // temperature of the contact without friction [K]

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("temperature", law.temperature,
          Allowed{.unit = "K", .low = -std::numeric_limits<double>::infinity()});
    visit("coefficient", law.coefficient, Allowed{""});
    visit("bulk", law.bulk, Allowed{.unit = "K", .low = -std::numeric_limits<double>::infinity()});
  }
  /// Throws std::invalid_argument for temperatures that do not increase or do not match.
  void check() const;
  double largest() const;
  double bound(double pressure) const { return largest() * pressure; }
  double ratio(double) const { return largest(); }
  /// Coefficient at a temperature rise above `bulk` [K], relative to the largest.
  double factor(double rise) const;
  bool operator==(const ThermalCoulomb&) const = default;
};

/// Coulomb friction that falls from kinetic + drop to kinetic as the slip rate increases; the drop
/// is halved at half_speed.
struct FallingCoulomb {
  static constexpr auto name = "falling_coulomb",
                        says = "Coulomb friction that falls with increasing slip rate.";
  static constexpr bool sticks = true;
  double kinetic, drop, half_speed, memory;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("kinetic", law.kinetic, Allowed{""});
    visit("drop", law.drop, Allowed{""});
    visit("half_speed", law.half_speed, Allowed::positive("m/s"));
    visit("memory", law.memory, Allowed{"m"});
  }
  double bound(double pressure) const { return (kinetic + drop) * pressure; }
  double ratio(double) const { return kinetic + drop; }
  SlipRateLaw rates() const { return {kinetic, drop, half_speed, memory}; }
  bool operator==(const FallingCoulomb&) const = default;
};

/// Description of a law for callers that create it by name.
struct FrictionDescription {
  std::string name, says;
  bool sticks;
  std::vector<LawParameter> parameters;
};

/// One of the laws, with checked parameters.
class FrictionLaw {
 public:
  using Laws = std::variant<FullSliding, Coulomb, Tresca, CappedCoulomb, Anisotropic, MappedCoulomb,
                            FallingCoulomb, ThirdBody, ThermalCoulomb>;
  using Values = std::map<std::string, std::vector<double>>;

  /// Throws std::invalid_argument with the name of the parameter, its value and the allowed range.
  explicit FrictionLaw(Laws law);
  /// values: one for each parameter that is a number.
  static FrictionLaw named(const std::string& name, const Values& values);
  static std::vector<FrictionDescription> descriptions();

  /// Whether cells stick below the bound, so that the shear is an unknown.
  bool sticks() const;
  /// Maximum shear under a pressure [Pa], in the direction in which it is largest; 0 out of
  /// contact, infinite if slip is prevented.
  double bound(double pressure) const;
  /// Maximum shear of each cell [Pa].
  Field bound(Field pressure) const;
  /// Ratio of the maximum shear to a pressure >= 0 [-]. The ratio does not increase with the
  /// pressure, so friction carries at most ratio(0) times the load.
  double ratio(double pressure) const;
  /// Ellipse of the admissible shears.
  Stretch stretch() const;
  /// Coefficient that depends on the place; null: it does not.
  const MappedCoulomb* map() const { return std::get_if<MappedCoulomb>(&law_); }
  /// Coefficient that depends on the temperature; null: it does not.
  const ThermalCoulomb* thermal() const { return std::get_if<ThermalCoulomb>(&law_); }
  /// Tangential displacement of a layer between the bodies per unit shear [m/Pa].
  double compliance() const;
  /// Layer whose strength depends on its plastic slip; null: none.
  const ThirdBody* hardening() const {
    const auto* layer = std::get_if<ThirdBody>(&law_);
    return layer != nullptr && layer->hardens() ? layer : nullptr;
  }
  /// Dependence on the slip rate.
  SlipRateLaw rates() const;
  bool is_frictionless() const { return bound(1.0) == 0; }
  bool prevents_slip() const;

  /// Whether the bodies are in full sliding with friction.
  bool slides() const { return shear_over_pressure(1) > 0; }
  /// Ratio of shear s_x to pressure on body 1 or 2 (index 0 or 1): in full sliding mu on body 2 and
  /// -mu on body 1, otherwise 0.
  double shear_over_pressure(int body) const;
  /// Tractions on body 2 that follow from a pressure [Pa]: with the shear of full sliding, or
  /// without shear.
  operators::Tractions tractions(Field pressure) const;
  /// Mirror planes of these tractions, and of the shear that partial slip adds to a symmetric
  /// contact.
  fft::Symmetry symmetry() const;

  bool operator==(const FrictionLaw&) const = default;

 private:
  /// Result of a function that is called with the law itself.
  template <class Function>
  decltype(auto) visit(Function&& function) const {
    return std::visit(std::forward<Function>(function), law_);
  }

  Laws law_;
};

}  // namespace samcontact::contact
