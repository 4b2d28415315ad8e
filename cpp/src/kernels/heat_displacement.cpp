// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_displacement.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "samcontact/kernels/heat_quadrature.hpp"

namespace samcontact::kernels {

Field heat_displacement(const HeatSource& source, const HeatPoints& points, double tol) {
  check_heat_arguments(source, points, 0, tol);
  if (source.is_steady() && !source.is_moving()) {
    throw std::invalid_argument(
        "heated must be finite for a stationary source, got inf: the steady displacement has no "
        "far-field limit");
  }
  // u = -2 int dS int (2/pi) sin^2 phi f_a(x - V S sin^2 phi/kappa; v) f_b(..) dphi, S = v^2
  if (nothing_yet(source)) return Field(points.x.size() * points.y.size());
  const HeatQuadrature quadrature(tol);
  HeatSum sum(source, points, {{0, 0, 0}}, quadrature.reach());
  for (const auto& width : quadrature.all_widths(source, sum, 0)) {
    const double S = width.v * width.v;
    const double factor = -2 * 2 * width.v * width.weight * 2 / std::numbers::pi;
    if (!source.is_moving()) {
      const double integral = (width.angle - std::sin(width.angle) * std::cos(width.angle)) / 2;
      sum.add(0, width.v, {factor * integral});
      continue;
    }
    for (const auto& [phi, weight] : quadrature.angles(source, sum, width, 1)) {
      const double s2 = std::sin(phi) * std::sin(phi);
      sum.add(S * s2, width.v, {factor * s2 * weight});
    }
    sum.end_width();
  }
  sum.flush();
  return sum.table(0);
}

}  // namespace samcontact::kernels
