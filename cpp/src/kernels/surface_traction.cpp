// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/surface_traction.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/kernels/corners.hpp"

namespace samcontact::kernels {
namespace {

// Keeps the quotients defined on the lines above the edges of the source, where their numerators
// vanish.

/// Elementary functions shared by the stress kernels.
struct Elementary {
  double R, s, t;

  Elementary(double x, double y, double z)
      : R(std::max(std::sqrt(x * x + y * y + z * z), 1e-140)),
        s(std::max(x * x + z * z, smallest_square)),
        t(std::max(y * y + z * z, smallest_square)) {}
};

}  // namespace

double pressure_displacement(double x, double y) {
  return x * log_ratio(y, x, 0.0) + y * log_ratio(x, y, 0.0);
}

double shear_displacement(double x, double y) {
  const double rho2 = std::max(x * x + y * y, smallest_square);
  return 0.5 * y * std::log(rho2) + x * std::atan2(std::copysign(1.0, x) * y, std::fabs(x));
}

double along_displacement(double x, double y, double nu) {
  return (1 - nu) * x * log_ratio(y, x, 0.0) + y * log_ratio(x, y, 0.0);
}

double cross_displacement(double x, double y, double nu) { return -nu * std::hypot(x, y); }

Stress pressure_stress(double x, double y, double z, double nu) {
  const Elementary e(x, y, z);
  const double k = 1 - 2 * nu;
  const double A_x = std::atan2(x * y, e.s + z * e.R), A_y = std::atan2(x * y, e.t + z * e.R);
  // tan T_z = x y/(z R), because (s + z R)(t + z R) - x^2 y^2 = z R (s + t + 2 z R).
  const double T_z = A_x + A_y;
  const double xx = z * x * y / (e.R * e.s), yy = z * x * y / (e.R * e.t);
  return {
      xx - k * A_x - 2 * nu * T_z, yy - k * A_y - 2 * nu * T_z, -T_z - (xx + yy),
      z * z * x / (e.R * e.t),     z * z * y / (e.R * e.s),     -z / e.R - k * std::log(e.R + z)};
}

Stress shear_stress(double x, double y, double z, double nu) {
  const Elementary e(x, y, z);
  const double k = 1 - 2 * nu;
  const double T = e.R + z;
  const double L_x = log_ratio(x, y, z);
  const double L_y = log_ratio(y, x, z);
  return {2 * L_y + x * x * y / (e.s * e.R) - k * y / T,
          -y / e.R + k * y / T + 2 * nu * L_y,
          z * z * y / (e.R * e.s),
          -z / e.R,
          -std::atan2(x * y, z * e.R) + z * x * y / (e.R * e.s),
          L_x - x / e.R + k * x / T};
}

}  // namespace samcontact::kernels
