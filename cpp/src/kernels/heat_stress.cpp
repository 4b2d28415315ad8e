// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_stress.hpp"

#include <cmath>
#include <numbers>

#include "samcontact/base/errors.hpp"
#include "samcontact/kernels/heat_quadrature.hpp"
#include "samcontact/kernels/heat_steady.hpp"
#include "samcontact/kernels/heat_temperature.hpp"

// With w the wavenumber, T'' - w^2 T = dT/dx for the heat of age x, P'' - w^2 P = -T, P'(0) = 0 and
// B = P(0) exp(-w z), per 2 G (1 + nu) alpha/(1 - nu):
//
//   Q = P + (1 - 2 nu) B - z w B,   D = B + z w B - P = 2 (1 - nu) B - Q,   H = dP/dz + z w^2 B
//   sigma_xx = -T - d2Q/dx2 - 2 nu (d2B/dx2 + d2B/dy2),   sigma_xy = -d2Q/dxdy
//   sigma_zz = -(d2D/dx2 + d2D/dy2),   sigma_xz = -dH/dx
//
// An element of heat of age x has P = int_x^inf exp(-w^2 S) W dS, W = exp(-z^2/4S)/sqrt(pi S),
// since T solves the heat equation; and exp(-w z) = 2/sqrt(pi) int exp(-y^2 - w^2 z^2/4y^2) dy
// makes of P(0) exp(-w z)
//
//   B = int_x^inf exp(-w^2 S) W erfc(z tan(phi)/2v) dS,   x = S sin^2 phi, S = v^2,
//
// w B = -dB/dz, w^2 B = d2B/dz2. exp(-w^2 S) is f_a f_b of heat_sum.hpp in real space.

namespace samcontact::kernels {
namespace {

enum { weight_q, weight_b, weight_h };

/// Weights of Q, B and H for one Gaussian and one age, W left out.
std::array<double, 3> stress_weights(double z, double v, double phi, double nu) {
  const double S = v * v, cosine = std::cos(phi);
  const double slope = std::sin(phi) / cosine / (2 * v);  // of the argument of erfc
  const double B = std::erfc(z * slope);
  const double gauss = 2 * std::numbers::inv_sqrtpi * slope * std::exp(-z * z * slope * slope);
  const double B_z = -z / (2 * S) * B - gauss;
  const double B_zz = -B / (2 * S) - z / (2 * S) * B_z + z * gauss / (2 * S * cosine * cosine);
  return {1 + (1 - 2 * nu) * B + z * B_z, B, -z / (2 * S) + z * B_zz};
}

Field steady_stress(const HeatSource& source, const HeatPoints& points, double z, double nu) {
  const std::size_t ny = points.y.size(), size = points.x.size() * ny;
  Field table(6 * size);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    for (std::size_t j = 0; j < ny; ++j) {
      const auto s = steady_heat_stress(points.x[i], points.y[j], z, source.a, source.b);
      const std::size_t at = i * ny + j;
      table[at] = (1 - nu) * s[0];
      table[size + at] = (1 - nu) * s[1];
      table[5 * size + at] = (1 - nu) * s[2];
    }
  }
  return table;
}

/// Adds all Gaussians of one width.
void add_width(const HeatQuadrature& quadrature, const HeatSource& source, const HeatWidth& width,
               double z, double nu, HeatSum& sum) {
  const double S = width.v * width.v, ratio = z / (2 * width.v);
  // dS dx W
  const double factor = 2 * std::numbers::inv_sqrtpi * S * std::exp(-ratio * ratio) * width.weight;
  std::array<double, 3> at_rest{};
  for (const auto& [phi, weight] : quadrature.angles(source, sum, width, ratio / 8)) {
    std::array<double, 3> w = stress_weights(z, width.v, phi, nu);
    for (int n = 0; n < 3; ++n) w[n] *= factor * std::sin(2 * phi) * weight;
    if (source.is_moving()) {
      sum.add(S * std::sin(phi) * std::sin(phi), width.v, w);
    } else {
      for (int n = 0; n < 3; ++n) at_rest[n] += w[n];
    }
  }
  if (source.is_moving()) {
    sum.end_width();
  } else {
    sum.add(0, width.v, at_rest);
  }
}

}  // namespace

Field heat_stress(const HeatSource& source, const HeatPoints& points, double z, double nu,
                  double tol) {
  check_heat_arguments(source, points, z, tol);
  require(nu >= 0 && nu < 0.5, "nu", "in [0, 0.5)", nu);
  if (source.is_steady() && !source.is_moving()) return steady_stress(source, points, z, nu);
  if (nothing_yet(source)) return Field(6 * points.x.size() * points.y.size());

  std::vector<HeatProduct> products{{2, 0, weight_b}, {0, 2, weight_b}, {1, 1, weight_q}};
  if (z > 0) {
    products.insert(products.end(),
                    {{2, 0, weight_q}, {0, 2, weight_q}, {1, 0, weight_h}, {0, 1, weight_h}});
  }
  const HeatQuadrature quadrature(tol);
  HeatSum sum(source, points, products, quadrature.reach());
  for (const auto& width : quadrature.all_widths(source, sum, z)) {
    add_width(quadrature, source, width, z, nu, sum);
  }
  sum.flush();

  const Field T = heat_temperature(source, points, z, tol);
  const std::size_t size = T.size();
  Field table(6 * size);
  for (std::size_t n = 0; n < size; ++n) {
    const double B_xx = sum.table(0)[n], B_yy = sum.table(1)[n];
    const double Q_xx = z > 0 ? sum.table(3)[n] : 2 * (1 - nu) * B_xx;
    const double Q_yy = z > 0 ? sum.table(4)[n] : 2 * (1 - nu) * B_yy;
    const double spread = 2 * nu * (B_xx + B_yy);
    table[n] = -T[n] - Q_xx - spread;
    table[size + n] = -T[n] - Q_yy - spread;
    table[5 * size + n] = -sum.table(2)[n];
    if (z > 0) {
      table[2 * size + n] = Q_xx + Q_yy - 2 * (1 - nu) * (B_xx + B_yy);
      table[3 * size + n] = -sum.table(6)[n];
      table[4 * size + n] = -sum.table(5)[n];
    }
  }
  return table;
}

}  // namespace samcontact::kernels
