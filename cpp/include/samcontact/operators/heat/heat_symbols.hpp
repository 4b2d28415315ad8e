// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal stress of one wavenumber.
#pragma once

#include <cmath>

namespace samcontact::operators {

/// sin(x)/x.
inline double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

/// Temperature T at a depth; P and its slope, P'' - w^2 P = -T, P' = 0 at the surface and P = 0 at
/// infinite depth; w P at the surface.
template <class Number>
struct ThermalProfile {
  Number t, p, slope, base;
};

/// (1 - nu) sigma/(E alpha) of components xx, yy, zz, yz, xz, xy; yz and xz over -i. P is Goodier's
/// displacement potential, and the image that frees the surface is in `base`.
template <class Number>
Number heat_stress_symbol(int component, double nu, double z, double w1, double w2,
                          const ThermalProfile<Number>& at) {
  const double w = std::hypot(w1, w2);
  if (w == 0) return component < 2 ? -at.t : Number{};
  const double wz = w * z;
  const Number image = at.base * (std::exp(-wz) / w);
  const auto in_plane = [&](double product) -> Number {
    return product * (at.p + (1 - 2 * nu - wz) * image);
  };
  const auto out_of_plane = [&](double wi) -> Number {
    return wi * (at.slope + z * w * w * image);
  };
  switch (component) {
    case 0:
      return in_plane(w1 * w1) + 2 * nu * w * w * image - at.t;
    case 1:
      return in_plane(w2 * w2) + 2 * nu * w * w * image - at.t;
    case 2:
      return w * w * ((1 + wz) * image - at.p);
    case 3:
      return out_of_plane(w2);
    case 4:
      return out_of_plane(w1);
    default:
      return in_plane(w1 * w2);
  }
}

}  // namespace samcontact::operators
