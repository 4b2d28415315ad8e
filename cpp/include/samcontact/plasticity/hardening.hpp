// SPDX-License-Identifier: GPL-3.0-or-later
// Hardening laws: yield stress [Pa] and its work as functions of the equivalent plastic strain.
//
// Each law is a struct here and an alternative of Hardening::Laws. The struct declares its name,
// its parameters and their ranges; checks, bindings, case files and the radial return read them
// from there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/law_parameters.hpp"

namespace samcontact::plasticity {

/// Yield stress and d yield_stress / dg [Pa], evaluated together: a power is the most expensive
/// operation here.
struct Point {
  double yield_stress, slope;
};

/// Elastic: never yields.
struct NoYield {
  static constexpr auto name = "elastic", says = "Linear elasticity.";

  template <class Self, class Visit>
  static void parameters(Self&, const Visit&) {}
  void prepare(const Elastic&) {}
  static Point at(double) { return {std::numeric_limits<double>::infinity(), 0.0}; }
  static double work(double) { return 0.0; }
  bool operator==(const NoYield&) const = default;
};

struct PerfectPlastic {
  static constexpr auto name = "perfect_plastic", says = "Elastic, perfectly plastic.";
  double yield_stress;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("yield_stress", law.yield_stress, Allowed::positive("Pa"));
  }
  void prepare(const Elastic&) {}
  Point at(double) const { return {yield_stress, 0.0}; }
  double work(double g) const { return yield_stress * g; }
  bool operator==(const PerfectPlastic&) const = default;
};

/// yield_stress + modulus g, with the modulus E Et/(E - Et) for the tangent modulus Et < E of the
/// uniaxial curve.
struct LinearHardening {
  static constexpr auto name = "linear_hardening",
                        says = "Linear isotropic hardening; tangent modulus of the uniaxial curve.";
  double yield_stress, tangent_modulus;
  double modulus = 0.0;  // derived from the other parameters

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("yield_stress", law.yield_stress, Allowed::positive("Pa"));
    visit("tangent_modulus", law.tangent_modulus, Allowed{"Pa"});
  }
  void prepare(const Elastic& elastic);
  Point at(double g) const { return {yield_stress + modulus * g, modulus}; }
  double work(double g) const { return (yield_stress + 0.5 * modulus * g) * g; }
  bool operator==(const LinearHardening&) const = default;
};

/// B (C + 1e6 g)^n: Swift's law, in which C is in microstrain. Boucly (2008), eq. (2.162).
struct Swift {
  static constexpr auto name = "swift", says = "Swift hardening B (C + 1e6 g)^n.";
  static constexpr double micro = 1e6;
  double B, C, n;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("B", law.B, Allowed::positive("Pa"));
    visit("C", law.C, Allowed::positive("microstrain"));
    visit("n", law.n, Allowed{.unit = "", .high = 1.0});
  }
  void prepare(const Elastic&) {}
  Point at(double g) const {
    const double base = C + micro * g, stress = B * std::pow(base, n);
    return {stress, n * micro * stress / base};
  }
  double work(double g) const;
  bool operator==(const Swift&) const = default;
};

/// Voce's law: from yield_stress to saturation_stress, sigma_inf - (sigma_inf - sigma_0) e^(-rate
/// g). Voce (1948), J. Inst. Metals 74, 537-562.
struct Voce {
  static constexpr auto name = "voce",
                        says =
                            "Voce hardening s_inf - (s_inf - s_0) exp(-rate g), which saturates.";
  double yield_stress, saturation_stress, rate;

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("yield_stress", law.yield_stress, Allowed::positive("Pa"));
    visit("saturation_stress", law.saturation_stress, Allowed::positive("Pa"));
    visit("rate", law.rate, Allowed::positive(""));
  }
  void prepare(const Elastic&) const;
  Point at(double g) const {
    const double range = saturation_stress - yield_stress, grown = -std::expm1(-rate * g);
    return {yield_stress + range * grown, range * rate * (1 - grown)};
  }
  double work(double g) const;
  bool operator==(const Voce&) const = default;
};

/// Straight segment of a curve, given by a point and the slope.
struct Line {
  double strain, stress, slope;

  Point at(double g) const { return {stress + slope * (g - strain), slope}; }
};

/// Points of a curve: piecewise linear, constant beyond the last point.
struct Tabulated {
  static constexpr auto
      name = "tabulated",
      says = "Points of a measured curve: piecewise linear, constant beyond the last.";
  static constexpr std::size_t max_points = 4096;  // points; limit of attributes in HDF5 files
  std::vector<double> plastic_strain, stress;
  std::vector<double>
      slopes = {},
      works = {};  // from each point on, and up to it; derived from the other parameters

  template <class Self, class Visit>
  static void parameters(Self& law, const Visit& visit) {
    visit("plastic_strain", law.plastic_strain, Allowed{""});
    visit("stress", law.stress, Allowed::positive("Pa"));
  }
  void prepare(const Elastic&);
  Point at(double g) const { return line(piece_at(g)).at(g); }
  double work(double g) const;
  /// Segment in which an increment from g ends. beyond(strain, stress): whether the increment
  /// passes this point of the curve.
  template <class Beyond>
  Line piece(double g, const Beyond& beyond) const {
    const auto passed = [&](const double& strain) {
      return beyond(strain, stress[&strain - plastic_strain.data()]);
    };
    const auto first = plastic_strain.begin() + static_cast<std::ptrdiff_t>(piece_at(g)) + 1;
    const auto next = std::partition_point(first, plastic_strain.end(), passed);
    return line(static_cast<std::size_t>(next - plastic_strain.begin()) - 1);
  }
  std::size_t piece_at(double g) const {
    const auto next = std::upper_bound(plastic_strain.begin() + 1, plastic_strain.end(), g);
    return static_cast<std::size_t>(next - plastic_strain.begin()) - 1;
  }
  Line line(std::size_t n) const { return {plastic_strain[n], stress[n], slopes[n]}; }
  bool operator==(const Tabulated&) const = default;
};

/// Law with `factor` times the yield stress of another law, which must outlive it.
template <class Law>
struct Scaled {
  const Law& law;
  double factor;

  Point at(double g) const {
    const Point point = law.at(g);
    return {factor * point.yield_stress, factor * point.slope};
  }
  template <class Beyond>
  Line piece(double g, const Beyond& beyond) const
    requires requires { law.piece(g, beyond); }
  {
    const Line line =
        law.piece(g, [&](double strain, double stress) { return beyond(strain, factor * stress); });
    return {line.strain, factor * line.stress, factor * line.slope};
  }
};

/// Description of a law for callers that create it by name.
struct LawDescription {
  std::string name, says;
  bool yields;
  std::vector<LawParameter> parameters;
};

/// One of the laws, with checked parameters.
class Hardening {
 public:
  using Laws = std::variant<NoYield, PerfectPlastic, LinearHardening, Swift, Voce, Tabulated>;
  /// Parameters by name; a scalar parameter has one value.
  using Values = std::map<std::string, std::vector<double>>;

  /// Throws std::invalid_argument with the name of the parameter, its value and the allowed range.
  Hardening(Laws law, const Elastic& elastic);
  static Hardening named(const std::string& name, const Values& values, const Elastic& elastic);
  static std::vector<LawDescription> descriptions();

  /// Result of a function that is called with the law itself.
  template <class Function>
  decltype(auto) visit(Function&& function) const {
    return std::visit(std::forward<Function>(function), law_);
  }
  bool yields() const { return !std::holds_alternative<NoYield>(law_); }
  Point at(double g) const {
    return visit([g](const auto& law) { return law.at(g); });
  }
  double yield_stress(double g) const { return at(g).yield_stress; }
  /// Integral of the yield stress from 0 to g [J/m^3]; 0 for an elastic law.
  double work(double g) const {
    return visit([g](const auto& law) { return law.work(g); });
  }
  bool operator==(const Hardening&) const = default;

 private:
  Laws law_;
};

}  // namespace samcontact::plasticity
