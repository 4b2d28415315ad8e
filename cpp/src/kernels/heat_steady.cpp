// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_steady.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/gauss.hpp"

namespace samcontact::kernels {
namespace {

using std::numbers::pi;
// In half sizes. Corner sums lose about (distance / size)^2 of their digits; beyond, four by four
// Gauss points integrate the point source to (size / distance)^8.
constexpr double far_ratio = 30;

bool is_far(double x, double y, double z, double a, double b) {
  return std::hypot(x, y, z) > far_ratio * std::max(a, b);
}

/// Integral of point(x - xi, y - eta) over the rectangle, far_ratio from it.
template <std::size_t N, class Point>
std::array<double, N> integrate(double x, double y, double a, double b, const Point& point) {
  static const auto rule = gauss_legendre(4);
  std::array<double, N> sum{};
  for (const auto& u : rule) {
    for (const auto& v : rule) {
      const std::array<double, N> f = point(x + (2 * u.at - 1) * a, y + (2 * v.at - 1) * b);
      for (std::size_t n = 0; n < N; ++n) sum[n] += 4 * a * b * u.weight * v.weight * f[n];
    }
  }
  return sum;
}

}  // namespace

double steady_heat_temperature(double x, double y, double z, double a, double b) {
  if (is_far(x, y, z, a, b)) {
    return integrate<1>(
               x, y, a, b,
               [z](double X, double Y) { return std::array{1 / std::hypot(X, Y, z)}; })[0] /
           (2 * pi);
  }
  // T = q/(2 pi k) S2[X ln(Y + R) + Y ln(X + R) - z atan(X Y/(z R))]
  const auto corner = [z](double X, double Y) {
    const double R = std::sqrt(X * X + Y * Y + z * z);
    return std::array{X * log_ratio(Y, X, z) + Y * log_ratio(X, Y, z) -
                      z * std::atan2(X * Y, z * R)};
  };
  return corner_sum_2d<1>(x, y, a, b, corner)[0] / (2 * pi);
}

std::array<double, 3> steady_heat_stress(double x, double y, double z, double a, double b) {
  // Plane stress with the harmonic Airy function F = E alpha/(2 pi k) (z ln(R + z) - R) of a point
  // source: F,zz = E alpha T, hence sigma_xx + sigma_yy = F,yy + F,xx = -E alpha T.
  std::array<double, 3> sum{};
  if (is_far(x, y, z, a, b)) {
    sum = integrate<3>(x, y, a, b, [z](double X, double Y) {
      const double R = std::hypot(X, Y, z);
      const double T = R + z;
      const double d = 1 / (R * T * T);
      return std::array{-(X * X + z * T) * d, -(Y * Y + z * T) * d, -X * Y * d};
    });
  } else {
    sum = corner_sum_2d<3>(x, y, a, b, [z](double X, double Y) {
      const double R = std::sqrt(X * X + Y * Y + z * z);
      const double A_x = std::atan2(X * Y, X * X + z * z + z * R);
      const double A_y = std::atan2(X * Y, Y * Y + z * z + z * R);
      return std::array{z * A_y - Y * log_ratio(X, Y, z), z * A_x - X * log_ratio(Y, X, z),
                        R - z * std::log(std::max(R + z, smallest_square))};
    });
  }
  for (double& v : sum) v /= 2 * pi;
  return sum;
}

double steady_heat_displacement(double x, double y, double a, double b, double r0) {
  double sum = 0.0;
  if (is_far(x, y, 0, a, b)) {
    sum = integrate<1>(x, y, a, b, [r0](double X, double Y) {
      return std::array{std::log(std::hypot(X, Y) / r0)};
    })[0];
  } else {
    // g = 1/2 [X Y ln(X^2 + Y^2) - 3 X Y + X^2 atan(Y/X) + Y^2 atan(X/Y)], g,xy = ln r
    sum = corner_sum_2d<1>(x, y, a, b, [r0](double X, double Y) {
      const double r2 = std::max(X * X + Y * Y, smallest_square);
      const double s = std::copysign(1.0, X), t = std::copysign(1.0, Y);
      return std::array{0.5 *
                        (X * Y * (std::log(r2 / (r0 * r0)) - 3) + X * X * std::atan2(s * Y, s * X) +
                         Y * Y * std::atan2(t * X, t * Y))};
    })[0];
  }
  return sum / (2 * pi);
}

double buried_heat_displacement(double x, double y, double d, double a, double b, double r0) {
  double sum = 0.0;
  if (is_far(x, y, d, a, b)) {
    sum = integrate<1>(x, y, a, b, [d, r0](double X, double Y) {
      return std::array{std::log((std::hypot(X, Y, d) + d) / r0)};
    })[0];
  } else {
    sum = corner_sum_2d<1>(x, y, a, b, [d, r0](double X, double Y) {
      const double R = std::hypot(X, Y, d), s = X * X + d * d + d * R, t = Y * Y + d * d + d * R;
      return std::array{X * Y * (std::log((R + d) / r0) - 1.5) +
                        d * (X * log_ratio(Y, X, d) + Y * log_ratio(X, Y, d)) +
                        0.5 * (X * X * std::atan2(X * Y, s) + Y * Y * std::atan2(X * Y, t) -
                               d * d * std::atan2(X * Y, d * R))};
    })[0];
  }
  return sum / (2 * pi);
}

}  // namespace samcontact::kernels
