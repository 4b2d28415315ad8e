// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic elastic constants of one body.
#pragma once

#include <limits>

namespace samcontact {

/// Young's modulus E [Pa] and Poisson's ratio nu [-]. E = infinity means a rigid body.
struct Elastic {
  double E;
  double nu;

  /// Throws std::invalid_argument unless E is finite and > 0 and 0 <= nu < 0.5.
  static Elastic isotropic(double E, double nu);
  static Elastic rigid() { return {std::numeric_limits<double>::infinity(), 0.0}; }

  bool is_rigid() const { return E == std::numeric_limits<double>::infinity(); }
  /// Shear modulus G [Pa].
  double shear_modulus() const { return E / (2 * (1 + nu)); }
  /// 1 / (plane strain modulus) [1/Pa]; 0 for a rigid body.
  double normal_compliance() const { return is_rigid() ? 0.0 : (1 - nu * nu) / E; }
  /// (1 + nu)(1 - 2 nu) / E [1/Pa]: magnitude of the coupling from shear to u_z; 0 for a rigid
  /// body.
  double coupling_compliance() const { return is_rigid() ? 0.0 : (1 + nu) * (1 - 2 * nu) / E; }
  bool operator==(const Elastic&) const = default;
};

}  // namespace samcontact
