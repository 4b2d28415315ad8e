// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement u_z at the surface far from a uniformly loaded rectangle, by its moments: without
// the logarithms of the corner sum and without the digits it loses, 1e-16 r^2 at r widths.
#pragma once

#include <array>
#include <cstddef>

namespace samcontact::kernels {

/// The integral of 1/r over a rectangle about the origin, of `width` along x and `length` along y:
/// what the corner sum of pressure_displacement gives, to the last digits beyond begin().
class FarDisplacement {
 public:
  FarDisplacement(double width, double length);

  /// The distance from which on it holds.
  double begin() const { return begin_; }

  /// out[i] of the points (x[i], y).
  void evaluate(const double* x, double y, std::size_t count, double* out) const;

  /// Even moments up to the eighth: factors of cos(2 theta)^d / r^(2 k).
  static constexpr int orders = 4;
  using Factors = std::array<std::array<double, orders + 1>, orders + 1>;

 private:
  double area_, begin_;
  Factors factors_{};
};

}  // namespace samcontact::kernels
