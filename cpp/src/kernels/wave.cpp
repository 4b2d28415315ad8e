// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/wave.hpp"

#include <cmath>

namespace samcontact::kernels {
namespace {

struct Direction {
  double q, c, s;
  Direction(double kx, double ky) : q(std::hypot(kx, ky)), c(kx / q), s(ky / q) {}
};

/// Due to unit pressure, from exp(-y) and y exp(-y) at y = q z.
Stress pressure_stress_of(const Direction& k, double e, double ye, double nu) {
  const double along = ye - e, across = -2 * nu * e;
  const auto [q, c, s] = k;
  return {c * c * along + s * s * across, s * s * along + c * c * across, -e - ye, -s * ye, -c * ye,
          -c * s * (along - across)};
}

/// Due to unit shear along x, from exp(-y) and y at y = q z.
Stress shear_stress_of(const Direction& k, double e, double y, double nu) {
  const auto [q, c, s] = k;
  const double cc = c * c, ss = s * s;
  return {-c * e * (cc * (2 - y) + 2 * (1 + nu) * ss),
          -c * e * (2 * nu * cc - ss * y),
          -c * e * y,
          -c * s * e * y,
          e * (cc * y - 1),
          -s * e * (cc * (2 - y - 2 * nu) - cc + ss)};
}

/// Means of exp(-y) and of y exp(-y) over depths.
struct Means {
  double e, ye;
  Means(double q, double z0, double z1) {
    const double h = q * (z1 - z0), e0 = std::exp(-q * z0), lost = -std::expm1(-h);
    e = e0 * lost / h;
    ye = e0 * (q * z0 * lost + lost - h * std::exp(-h)) / h;
  }
};

/// ln of the distance, of which only differences matter.
double log_distance(double x, double z) { return 0.5 * std::log(std::fmax(x * x + z * z, 1e-280)); }

/// atan2(x, z), the angle from the z axis; on it 0 at z = 0 too.
double angle(double x, double z) { return x == 0 ? 0.0 : std::atan2(x, z); }

/// x/(x^2 + z^2) times a length of first order that vanishes with it.
double ratio(double numerator, double x, double z) {
  const double square = x * x + z * z;
  return square > 0 ? numerator / square : 0.0;
}

}  // namespace

std::array<double, 3> pressure_wave_displacement(double kx, double ky, double nu) {
  const Direction k(kx, ky);
  const double along = -0.5 * (1 - 2 * nu) / k.q;
  return {k.c * along, k.s * along, (1 - nu) / k.q};
}

std::array<double, 3> shear_wave_displacement(double kx, double ky, double nu) {
  const Direction k(kx, ky);
  return {((1 - nu) * k.c * k.c + k.s * k.s) / k.q, nu * k.c * k.s / k.q,
          0.5 * (1 - 2 * nu) * k.c / k.q};
}

Stress pressure_wave_stress(double kx, double ky, double z, double nu) {
  const Direction k(kx, ky);
  const double e = std::exp(-k.q * z);
  return pressure_stress_of(k, e, k.q * z * e, nu);
}

Stress shear_wave_stress(double kx, double ky, double z, double nu) {
  const Direction k(kx, ky);
  const double y = k.q * z;
  return shear_stress_of(k, std::exp(-y), y, nu);
}

Stress pressure_wave_mean(double kx, double ky, double z0, double z1, double nu) {
  const Direction k(kx, ky);
  const Means mean(k.q, z0, z1);
  return pressure_stress_of(k, mean.e, mean.ye, nu);
}

Stress shear_wave_mean(double kx, double ky, double z0, double z1, double nu) {
  const Direction k(kx, ky);
  const Means mean(k.q, z0, z1);
  return shear_stress_of(k, mean.e, mean.e > 0 ? mean.ye / mean.e : 0.0, nu);
}

Stress strip_pressure_stress(double x, double z, double nu) {
  const double arc = angle(x, z), xz = ratio(x * z, x, z), zz = ratio(z * z, x, z);
  return {xz - arc, -2 * nu * arc, -arc - xz, 0.0, zz, 0.0};
}

Stress strip_shear_stress(double x, double z, double nu) {
  const double arc = angle(x, z), xz = ratio(x * z, x, z), zz = ratio(z * z, x, z);
  const double log = log_distance(x, z);
  return {-2 * log - zz, -2 * nu * log, zz, 0.0, xz - arc, 0.0};
}

Stress strip_antiplane_stress(double x, double z) {
  return {0.0, 0.0, 0.0, -angle(x, z), 0.0, -log_distance(x, z)};
}

std::array<double, 6> bar_displacement(double x, double z, double nu) {
  const double log = x * log_distance(x, z), arc = z * angle(x, z);
  const double trace = -2 * nu * (log + arc);
  const double shear = x == 0 ? 0.0 : 2 * x * std::atan(z / x);
  return {2 * nu * log - (1 - 2 * nu) * arc + trace,
          trace,
          -2 * (1 - nu) * log - (1 - 2 * nu) * arc + trace,
          0.0,
          shear,
          0.0};
}

std::array<double, 6> bar_displacement_across(double x, double z, double nu) {
  const double log = z * log_distance(x, z), arc = x == 0 ? 0.0 : x * std::atan(z / x);
  return {2 * log + arc, 2 * nu * (log + arc), arc, 0.0, -2 * z * angle(x, z), 0.0};
}

std::array<double, 6> bar_displacement_along(double x, double z) {
  const double log = log_distance(x, z), arc = x == 0 ? 0.0 : x * std::atan(z / x);
  return {0.0, 0.0, 0.0, -2 * (x * log + z * angle(x, z)), 0.0, 2 * (z * log + arc)};
}

}  // namespace samcontact::kernels
