// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_temperature.hpp"

#include <cmath>
#include <numbers>

#include "samcontact/kernels/heat_quadrature.hpp"
#include "samcontact/kernels/heat_steady.hpp"

namespace samcontact::kernels {

Field heat_temperature(const HeatSource& source, const HeatPoints& points, double z, double tol) {
  check_heat_arguments(source, points, z, tol);
  if (source.is_steady() && !source.is_moving()) {
    Field table;
    for (const double x : points.x) {
      for (const double y : points.y) {
        table.push_back(steady_heat_temperature(x, y, z, source.a, source.b));
      }
    }
    return table;
  }
  // k T/q = 2/sqrt(pi) int_0^sqrt(kappa t) exp(-z^2/4v^2) f_a(x - V v^2/kappa; v) f_b(..; v) dv
  if (nothing_yet(source)) return Field(points.x.size() * points.y.size());
  const HeatQuadrature quadrature(tol);
  HeatSum sum(source, points, {{0, 0, 0}}, quadrature.reach());
  for (const auto& [v, weight, angle] : quadrature.newest_ages(source, sum, z)) {
    const double ratio = z / (2 * v);
    sum.add(v * v, v, {2 * std::numbers::inv_sqrtpi * std::exp(-ratio * ratio) * weight});
  }
  sum.flush();
  return sum.table(0);
}

}  // namespace samcontact::kernels
