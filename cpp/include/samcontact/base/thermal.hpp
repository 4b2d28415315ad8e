// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal constants of one body.
#pragma once

namespace samcontact {

/// Conductivity k [W/(m K)], linear expansion alpha [1/K], diffusivity kappa = k/(rho c) [m^2/s].
struct Thermal {
  double conductivity;
  double expansion;
  double diffusivity;

  /// Throws std::invalid_argument unless conductivity and diffusivity are finite and > 0 and the
  /// expansion is finite and >= 0.
  static Thermal of(double conductivity, double expansion, double diffusivity);

  bool operator==(const Thermal&) const = default;
};

}  // namespace samcontact
