// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels against their other forms, and against quadrature.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/far_displacement.hpp"
#include "samcontact/kernels/gauss.hpp"
#include "samcontact/kernels/surface_traction.hpp"

using namespace samcontact;

namespace {

double at(const kernels::FarDisplacement& far, double x, double y) {
  double value = 0.0;
  far.evaluate(&x, y, 1, &value);
  return value;
}

/// Exact to rounding where 1/r is smooth.
double by_quadrature(double x, double y, double width, double length) {
  double sum = 0.0;
  for (const auto& s : kernels::gauss_legendre(12)) {
    for (const auto& t : kernels::gauss_legendre(12)) {
      sum += s.weight * t.weight / std::hypot(x - width * (s.at - 0.5), y - length * (t.at - 0.5));
    }
  }
  return width * length * sum;
}

}  // namespace

TEST_CASE("multipole moments give the displacement far from a rectangle to rounding") {
  for (const double length : {0.25, 1.0, 3.0}) {
    const kernels::FarDisplacement far(1.0, length);
    for (const double r : {1.0, 1.5, 10.0, 300.0}) {
      for (const double angle : {0.0, 0.4, 0.7853981633974483, 1.2, 1.5707963267948966}) {
        const double x = r * far.valid_from() * std::cos(angle),
                     y = r * far.valid_from() * std::sin(angle);
        CAPTURE(x);
        CAPTURE(y);
        CHECK(at(far, x, y) == doctest::Approx(by_quadrature(x, y, 1.0, length)).epsilon(4e-15));
      }
    }
  }
}

TEST_CASE("at the start of the multipole range the corner sum agrees within its rounding") {
  const double length = 2.0;
  const kernels::FarDisplacement far(1.0, length);
  const double x = far.valid_from(), y = 3.0;
  const auto corner = [](double s, double t) {
    return std::array{kernels::pressure_displacement(s, t)};
  };
  const double sum = kernels::corner_sum_2d<1>(x, y, 0.5, 0.5 * length, corner)[0];
  CHECK(at(far, x, y) == doctest::Approx(sum).epsilon(1e-16 * x * x * 10));
}
