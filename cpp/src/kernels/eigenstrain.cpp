// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/eigenstrain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/eigenstrain_terms.hpp"

namespace samcontact::kernels {
namespace {

constexpr std::array<std::string_view, full_space_count> full_space_indices{
    "xxxx", "yyyy", "zzzz", "xxxy", "xxxz", "xyyy", "yyyz", "xzzz",
    "yzzz", "xxyy", "xxzz", "yyzz", "xxyz", "xyyz", "xyzz"};

constexpr std::array<std::string_view, image_count> image_indices{
    "xxxx", "xxxy", "xxyy", "xyyy", "yyyy", "xxxz", "xxyz", "xyyz", "yyyz",   // chi
    "xxxx", "xxxy", "xxyy", "xyyy", "yyyy", "xxxz", "xxyz", "xyyz", "yyyz",   // z theta
    "xxx",  "xxy",  "xyy",  "yyy",  "xxz",  "xyz",  "yyz",                    // phi, third
    "xxxx", "xxxy", "xxyy", "xyyy", "yyyy", "xxxz", "xxyz", "xyyz", "yyyz",   // z phi
    "xxxx", "xxxy", "xxyy", "xyyy", "yyyy", "xxxz", "xxyz", "xyyz", "yyyz"};  // phi, fourth

Parity parity_of(std::string_view indices) {
  const auto odd = [&](char c) { return std::count(indices.begin(), indices.end(), c) % 2 == 1; };
  return {odd('x'), odd('y'), odd('z')};
}

/// psi_aaaa for psi = R; b, c are the other two coordinates.
double psi_aaaa(double a, double b, double c, double R) {
  const double sign = a > 0 ? 1.0 : (a < 0 ? -1.0 : 0.0);
  const double T_a = std::atan2(b * c * sign, std::fabs(a) * R);
  const double ab = std::max(a * a + b * b, smallest_square);
  const double ac = std::max(a * a + c * c, smallest_square);
  return -2 * T_a + a * b * c / R * (1 / ab + 1 / ac);
}

/// psi_aaab.
double psi_aaab(double a, double b, double c, double R) {
  const double ab = std::max(a * a + b * b, smallest_square);
  return log_ratio(c, a, b) - a * a * c / (ab * R);
}

/// psi_aabb.
double psi_aabb(double a, double b, double c, double R) {
  return -a * b * c / (std::max(a * a + b * b, smallest_square) * R);
}

}  // namespace

std::array<double, 6> eigenstrain_displacement(double x, double y, double z, double nu) {
  const double R = std::max(std::sqrt(x * x + y * y + z * z), 1e-140);
  const double k = 1 - 2 * nu;
  const double xLy = x * log_ratio(y, x, z);
  const double yLx = y * log_ratio(x, y, z);
  const double L_z = std::log(std::max(R + z, 1e-140));
  const double T_z = std::atan2(x * y, z * R);
  const double A_x = std::atan2(x * y, std::max(x * x + z * z + z * R, smallest_square));
  const double A_y = std::atan2(x * y, std::max(y * y + z * z + z * R, smallest_square));
  // atan(yz/(xR)), atan(xz/(yR)): they occur multiplied by x or y, so 0 on those planes.
  const double xT_x = x == 0 ? 0.0 : x * std::atan(y * z / (x * R));
  const double yT_y = y == 0 ? 0.0 : y * std::atan(x * z / (y * R));
  const double trace = 2 * nu * (xLy + yLx - z * T_z);
  // The published forms take source minus field: the odd components yz and xz change sign.
  return {-2 * nu * xLy - k * z * A_x + trace,
          -2 * nu * yLx - k * z * A_y + trace,
          2 * (1 - nu) * (xLy + yLx) - k * z * T_z + trace,
          -2 * (x * L_z - yT_y),
          -2 * (y * L_z - xT_x),
          2 * (-2 * nu * R - k * z * L_z)};
}

std::array<double, 6> eigenstrain_side_displacement(double x, double y, double z, double nu) {
  const double R = std::max(std::sqrt(x * x + y * y + z * z), 1e-140);
  const double T = std::max(R + z, 1e-140);
  const double k = 1 - 2 * nu;
  const double L_z = std::log(T), q = 0.5 * (L_z + z / T);
  const double T_z = std::atan2(x * y, z * R);
  const double xT_x = x == 0 ? 0.0 : x * std::atan(y * z / (x * R));
  const double yT_y = y == 0 ? 0.0 : y * std::atan(x * z / (y * R));
  const double zLy_yLz = z * log_ratio(y, x, z) + y * L_z;
  return {xT_x + k * y * q - 2 * zLy_yLz,
          y * L_z - k * y * q - 2 * nu * (zLy_yLz - xT_x),
          xT_x - y * L_z,
          -2 * R,
          2 * (y * log_ratio(x, y, z) - z * T_z),
          -2 * (z * log_ratio(x, y, z) - yT_y + k * x * q)};
}

std::array<double, full_space_count> full_space_scalars(double x, double y, double z) {
  const double R = std::max(std::sqrt(x * x + y * y + z * z), 1e-140);
  // On the face of a cuboid at the free surface the limit from inside is required, not the mean.
  const double below = z == 0 ? smallest_square : z;
  return {psi_aaaa(x, y, z, R),
          psi_aaaa(y, x, z, R),
          psi_aaaa(below, x, y, R),
          psi_aaab(x, y, z, R),
          psi_aaab(x, z, y, R),
          psi_aaab(y, x, z, R),
          psi_aaab(y, z, x, R),
          psi_aaab(z, x, y, R),
          psi_aaab(z, y, x, R),
          psi_aabb(x, y, z, R),
          psi_aabb(x, z, y, R),
          psi_aabb(y, z, x, R),
          x / R,
          y / R,
          z / R};
}

std::array<double, image_count> image_scalars(double x, double y, double z) {
  const double R = std::max(std::sqrt(x * x + y * y + z * z), 1e-140);
  const double T = R + z;
  const double s = std::max(x * x + z * z, smallest_square);
  const double t = std::max(y * y + z * z, smallest_square);
  const double xy = x * y, xx = x * x, yy = y * y;
  const double R2 = R * R, R3 = R2 * R, RT = R * T, TT = T * T;
  const double Rs = R * s, Rt = R * t;
  const double ln_T = std::log(T);
  const double A_x = std::atan2(xy, s + z * R), A_y = std::atan2(xy, t + z * R);
  const double L_x = log_ratio(x, y, z), L_y = log_ratio(y, x, z);
  const double h = (2 * R + z) / (R3 * TT);
  return {
      // chi_ijkl
      xy / (2 * TT) - A_x, -(ln_T + z / T) / 2 - xx / (2 * TT), -xy / (2 * TT),
      -(ln_T + z / T) / 2 - yy / (2 * TT), xy / (2 * TT) - A_y, y / T - L_y, -x / T, -y / T,
      x / T - L_x,
      // z theta_ijkl
      A_x - xy / RT + xy * z / Rs + xy / (2 * TT), ln_T / 2 - z / (2 * T) + xx / RT - xx / (2 * TT),
      xy / RT - xy / (2 * TT), ln_T / 2 - z / (2 * T) + yy / RT - yy / (2 * TT),
      A_y - xy / RT + xy * z / Rt + xy / (2 * TT), L_y - xx * y / Rs, x / R, y / R,
      L_x - yy * x / Rt,
      // phi_ijk
      -y / RT + y * z / Rs, x / RT, y / RT, -x / RT + x * z / Rt, -xy / Rs, 1 / R, -xy / Rt,
      // z phi_ijkl
      xy / Rs * (-3 + 2 * xx / s + xx / R2), 1 / R - xx / R3, -xy / R3, 1 / R - yy / R3,
      xy / Rt * (-3 + 2 * yy / t + yy / R2), y * z / Rs * (-2 + 2 * xx / s + xx / R2) + y / RT,
      -x * z / R3 - x / RT, -y * z / R3 - y / RT, x * z / Rt * (-2 + 2 * yy / t + yy / R2) + x / RT,
      // phi_ijkl
      xy * h - xy * z / Rs * (1 / R2 + 2 / s), 1 / RT - xx * h, -xy * h, 1 / RT - yy * h,
      xy * h - xy * z / Rt * (1 / R2 + 2 / t), -y / Rs * (1 - xx / R2 - 2 * xx / s), -x / R3,
      -y / R3, -x / Rt * (1 - yy / R2 - 2 * yy / t)};
}

Parity full_space_parity(int kernel) { return parity_of(full_space_indices[kernel]); }
Parity image_parity(int kernel) { return parity_of(image_indices[kernel]); }

Parity component_parity(int component) {
  // xx, yy, zz, yz, xz, xy
  constexpr std::array<Parity, 6> parities{{{false, false, false},
                                            {false, false, false},
                                            {false, false, false},
                                            {false, true, true},
                                            {true, false, true},
                                            {true, true, false}}};
  return parities[component];
}

double inside_stress(int out, int in, double nu) {
  double value = out == in ? 2.0 : 0.0;
  if (out < 3 && in < 3) value += 2 * nu / (1 - nu);
  return value;
}

std::array<std::array<double, 6>, 6> eigenstrain_stress(double X, double Y, double z, double zc,
                                                        double a, double b, double c, double E,
                                                        double nu) {
  // In units of the cuboid's width, so that logarithms of lengths cost no digits.
  const double unit = 2 * a;
  const auto full = corner_sum_3d<full_space_count>(X / unit, Y / unit, (z - zc) / unit, a / unit,
                                                    b / unit, c / unit, full_space_scalars);
  const auto image = corner_sum_3d<image_count>(X / unit, Y / unit, (z + zc) / unit, a / unit,
                                                b / unit, c / unit, image_scalars);
  const double G = E / (2 * (1 + nu));
  const double factor = G / (8 * std::numbers::pi * (1 - nu));
  const bool inside = std::fabs(X) < a && std::fabs(Y) < b && z - zc >= -c && z - zc < c;
  const std::array<double, 3> powers{1.0, z / unit, z / unit * (z / unit)};

  std::array<std::array<double, 6>, 6> stress{};
  for (const auto& term : full_space_terms) {
    stress[term.out][term.in] += term.coefficient(nu) * full[term.kernel];
  }
  for (const auto& term : image_terms) {
    stress[term.out][term.in] += term.coefficient(nu) * powers[term.power] * image[term.kernel];
  }
  for (int out = 0; out < 6; ++out) {
    for (int in = 0; in < 6; ++in) {
      stress[out][in] *= factor;
      if (inside) stress[out][in] -= G * inside_stress(out, in, nu);
    }
  }
  return stress;
}

}  // namespace samcontact::kernels
