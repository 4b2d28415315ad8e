// SPDX-License-Identifier: GPL-3.0-or-later
// Materials: isotropic elasticity; J2 plasticity with isotropic and kinematic hardening, with a
// yield stress that may depend on depth; initial stress.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/free_faces.hpp"
#include "samcontact/base/over_depth.hpp"
#include "samcontact/base/relaxation.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/plasticity/hardening.hpp"

namespace samcontact::plasticity {

/// Kinematic hardening: a backstress X, by which the yield surface moves with the plastic strain e,
/// dX = 2/3 modulus de - recovery X dg (Armstrong & Frederick 1966; without recovery Prager 1949).
struct Backstress {
  double modulus = 0.0;   // [Pa]
  double recovery = 0.0;  // [-]

  bool operator==(const Backstress&) const = default;
};

/// Maximum number of backstresses that are added (Chaboche 1986).
constexpr int max_backstresses = 4;

/// Initial stress along the surface [Pa]. Because it depends only on depth and has no other
/// component, any profile is in equilibrium and leaves the surface free of tractions.
struct InitialStress {
  OverDepth xx, yy, xy;  // at the same depths

  double von_mises(double z) const;
  bool operator==(const InitialStress&) const = default;
};

struct Material {
  Elastic elastic;
  Hardening hardening;
  std::vector<Backstress> backstresses = {};
  std::optional<Thermal> thermal = {};
  std::optional<OverDepth> yield_profile = {};  // factor of the yield stress [-]; none: 1
  std::optional<InitialStress> initial_stress = {};
  FreeFaces free_faces = {};
  Relaxation relaxation = {};

  /// Both throw std::invalid_argument with the name of the parameter, its value and the allowed
  /// range.
  static Material with_law(double E, double nu, Hardening::Laws law);
  static Material with_law(double E, double nu, const std::string& name,
                           const Hardening::Values& values);
  static Material make_elastic(double E, double nu) { return with_law(E, nu, NoYield{}); }
  static Material make_rigid();

  /// Copy with these backstresses, in place of earlier ones, in addition to isotropic hardening.
  Material with_backstresses(const std::vector<Backstress>& terms) const;

  /// Copy with thermal constants.
  Material with_thermal(const Thermal& constants) const;

  /// Copy with another depth profile of the yield stress. Throws std::invalid_argument if the
  /// initial stress exceeds it.
  Material with_yield_profile(OverDepth factor) const;

  /// Copy with an initial stress. Throws std::invalid_argument if it exceeds the yield stress.
  Material with_initial_stress(InitialStress stress) const;

  /// Copy of an elastic material for a body with free faces. Throws std::invalid_argument for a
  /// rigid or plastic material, and unless low < high.
  Material with_free_faces(const FreeFaces& faces) const;

  /// Copy of an elastic material that relaxes. Throws std::invalid_argument for a rigid or plastic
  /// material, and for one with free faces or initial stress.
  Material with_relaxation(const Relaxation& terms) const;

  bool operator==(const Material&) const = default;
  bool is_plastic() const { return hardening.yields(); }
  bool is_viscoelastic() const { return relaxation.is_on(); }
  /// Factor of the yield stress at a depth.
  double yield_factor(double z) const { return yield_profile ? yield_profile->at(z) : 1.0; }
  /// Minimum initial yield stress over all depths [Pa].
  double smallest_yield_stress() const {
    const double yield_stress = hardening.yield_stress(0.0);
    return yield_profile ? yield_stress * yield_profile->smallest() : yield_stress;
  }
};

}  // namespace samcontact::plasticity
