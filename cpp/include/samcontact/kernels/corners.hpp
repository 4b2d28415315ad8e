// SPDX-License-Identifier: GPL-3.0-or-later
// Corner sums: every influence coefficient of a rectangle or cuboid is an alternating sum of one
// elementary function over its corners.
#pragma once

#include <array>
#include <cmath>

namespace samcontact::kernels {

/// Replaces squares of lengths that are zero in divisors and logarithms.
constexpr double smallest_square = 1e-280;

/// L(u; v, w) = asinh(u / sqrt(v^2 + w^2)): ln(u + R) without its cancellation for u < 0 (the
/// difference, ln(v^2 + w^2)/2, is annihilated by the corner sum over u).
inline double log_ratio(double u, double v, double w) {
  return std::asinh(u / std::sqrt(std::fmax(v * v + w * w, smallest_square)));
}

/// sum_{s,t=+-1} s t F(X + s a, Y + t b). `corner(x, y)` returns an array of N functions.
template <std::size_t N, class Corner>
std::array<double, N> corner_sum_2d(double X, double Y, double a, double b, const Corner& corner) {
  std::array<double, N> sum{};
  for (int s = -1; s <= 1; s += 2) {
    for (int t = -1; t <= 1; t += 2) {
      const std::array<double, N> f = corner(X + s * a, Y + t * b);
      for (std::size_t m = 0; m < N; ++m) sum[m] += s * t * f[m];
    }
  }
  return sum;
}

/// sum_{s,t,r=+-1} s t r F(X + s a, Y + t b, Z + r c).
template <std::size_t N, class Corner>
std::array<double, N> corner_sum_3d(double X, double Y, double Z, double a, double b, double c,
                                    const Corner& corner) {
  std::array<double, N> sum{};
  for (int r = -1; r <= 1; r += 2) {
    const auto plane =
        corner_sum_2d<N>(X, Y, a, b, [&](double x, double y) { return corner(x, y, Z + r * c); });
    for (std::size_t m = 0; m < N; ++m) sum[m] += r * plane[m];
  }
  return sum;
}

}  // namespace samcontact::kernels
