// SPDX-License-Identifier: GPL-3.0-or-later
// Friction laws: maximum shear of a cell as a function of its pressure.
//
// Each law is a struct here and an alternative of FrictionLaw::Laws. The struct declares its name,
// its parameters and their ranges; checks, bindings and case files read them from there.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "samcontact/base/law_parameters.hpp"
#include "samcontact/fft/mirrored_transform.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::contact {

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

/// Description of a law for callers that create it by name.
struct FrictionDescription {
  std::string name, says;
  bool sticks;
  std::vector<LawParameter> parameters;
};

/// One of the laws, with checked parameters.
class FrictionLaw {
 public:
  using Laws = std::variant<FullSliding, Coulomb, Tresca, CappedCoulomb>;
  using Values = std::map<std::string, double>;

  /// Throws std::invalid_argument with the name of the parameter, its value and the allowed range.
  explicit FrictionLaw(Laws law);
  static FrictionLaw named(const std::string& name, const Values& values);
  static std::vector<FrictionDescription> descriptions();

  /// Whether cells stick below the bound, so that the shear is an unknown.
  bool sticks() const;
  /// Maximum shear under a pressure [Pa]; 0 out of contact, infinite if slip is prevented.
  double bound(double pressure) const;
  /// Maximum shear of each cell [Pa].
  Field bound(Field pressure) const;
  /// Ratio of the maximum shear to a pressure >= 0 [-]. The ratio does not increase with the
  /// pressure, so friction carries at most ratio(0) times the load.
  double ratio(double pressure) const;
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
  /// Mirror planes of these tractions.
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
