// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement u_z far from a uniformly loaded rectangle, by multipole moments: without the
// logarithms of the corner sum and without its cancellation error, 1e-16 r^2 at a distance of r
// widths.
#pragma once

#include <array>
#include <cstddef>

namespace samcontact::kernels {

/// Integral of 1/r over a rectangle around the origin, of `width` along x and `length` along y:
/// equal to the corner sum of pressure_displacement to rounding beyond valid_from().
class FarDisplacement {
 public:
  FarDisplacement(double width, double length);

  /// Distance from which the expansion is valid.
  double valid_from() const { return valid_from_; }

  /// out[i] at the points (x[i], y).
  void evaluate(const double* x, double y, std::size_t count, double* out) const;

  /// Even moments up to the eighth: factors of cos(2 theta)^d / r^(2 k).
  static constexpr int orders = 4;
  using Factors = std::array<std::array<double, orders + 1>, orders + 1>;

 private:
  double area_, valid_from_;
  Factors factors_{};
};

}  // namespace samcontact::kernels
