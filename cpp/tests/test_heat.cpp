// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of separable Gaussians, their nodes, and arguments that the Python layer never passes.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "samcontact/kernels/gauss.hpp"
#include "samcontact/kernels/heat_displacement.hpp"
#include "samcontact/kernels/heat_stress.hpp"
#include "samcontact/kernels/heat_sum.hpp"
#include "samcontact/kernels/heat_temperature.hpp"

using namespace samcontact;
using namespace samcontact::kernels;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The profile of heat_sum.hpp and its derivatives, point by point.
double profile(double x, double a, double v, int order) {
  const auto edge = [&](double u) {
    const double slope = std::exp(-u * u) / std::sqrt(std::acos(-1.0)) / (2 * v);
    if (order == 0) return 0.5 * std::erf(u);
    return order == 1 ? slope : -u / v * slope;
  };
  return edge((x + a) / (2 * v)) - edge((x - a) / (2 * v));
}

}  // namespace

TEST_CASE("Gauss-Legendre integrates polynomials of degree 2 n - 1") {
  for (int n = 1; n <= 20; ++n) {
    double sum = 0, last = 0;
    for (const auto& [at, weight] : gauss_legendre(n)) {
      CHECK(at > last);
      last = at;
      sum += weight * std::pow(at, 2 * n - 1);
    }
    CHECK(last < 1);
    CHECK(sum == doctest::Approx(1.0 / (2 * n)).epsilon(1e-13));
  }
}

TEST_CASE("a sum of terms in batches of any length is their sum") {
  const HeatSource source{0.5, 0.3, 1.0, 2.0, -1.0};
  // a lattice that shares edges along x; points along y that do not
  const HeatPoints points{{-2, -1, 0, 1, 2, 3}, {-0.7, 0.1, 0.3, 1.9}};
  for (const int terms : {1, 3, 4, 15, 16, 17, 40}) {
    HeatSum sum(source, points, {{0, 0, 0}, {2, 1, 2}, {1, 0, 1}}, 20);
    std::vector<double> direct(3 * 24);
    for (int t = 0; t < terms; ++t) {
      const double age = 0.05 * t, v = 0.2 + 0.1 * t;
      const std::array<double, 3> w{1.0, std::cos(t), 0.5 * t};
      sum.add(age, v, w);
      for (int n = 0; n < 24; ++n) {
        const double x = points.x[n / 4] - 2 * age, y = points.y[n % 4] + age;
        direct[n] += w[0] * profile(x, 0.5, v, 0) * profile(y, 0.3, v, 0);
        direct[24 + n] += w[2] * profile(x, 0.5, v, 2) * profile(y, 0.3, v, 1);
        direct[48 + n] += w[1] * profile(x, 0.5, v, 1) * profile(y, 0.3, v, 0);
      }
    }
    sum.flush();
    for (int n = 0; n < 72; ++n) {
      CHECK(sum.table(n / 24)[n % 24] == doctest::Approx(direct[n]).epsilon(1e-11).scale(1e-3));
    }
  }
}

TEST_CASE("tables of one point, tiny and huge numbers are finite") {
  for (const double heated : {0.0, 1e-120, 1e-30, 1e-6, 1.0, 1e59, infinity}) {
    for (const double speed : {0.0, 1e-59, 1e-9, 1.0, 1e4}) {
      for (const double z : {0.0, 1e-12, 1.0, 1e6}) {
        const HeatSource source{0.5, 0.5, heated, speed, 0};
        const HeatPoints points{{0.5}, {0.1}};
        CHECK(std::isfinite(heat_temperature(source, points, z, 1e-3)[0]));
        for (const double s : heat_stress(source, points, z, 0.3, 1e-3)) CHECK(std::isfinite(s));
        if (speed == 0 && std::isinf(heated)) continue;
        CHECK(std::isfinite(heat_displacement(source, points, 1e-3)[0]));
      }
    }
  }
}

TEST_CASE("invalid arguments are rejected") {
  const HeatSource good{0.5, 0.5, 1.0, 0, 0};
  const HeatPoints points{{0.0, 1.0}, {0.0}};
  const auto refused = [](const HeatSource& source, const HeatPoints& at, double z, double tol) {
    CHECK_THROWS_AS(heat_temperature(source, at, z, tol), std::invalid_argument);
    CHECK_THROWS_AS(heat_stress(source, at, z, 0.3, tol), std::invalid_argument);
  };
  refused({0, 0.5, 1, 0, 0}, points, 0, 1e-6);
  refused({0.5, infinity, 1, 0, 0}, points, 0, 1e-6);
  refused({0.5, 0.5, -1, 0, 0}, points, 0, 1e-6);
  refused({0.5, 0.5, 1e70, 0, 0}, points, 0, 1e-6);
  refused({0.5, 0.5, 1, infinity, 0}, points, 0, 1e-6);
  refused({0.5, 0.5, 1, 0, 1e-80}, points, 0, 1e-6);
  refused({0.5, 0.5, 1, 0, 1e8}, points, 0, 1e-6);
  refused(good, points, -1, 1e-6);
  refused(good, points, 0, 0);
  refused(good, {{1.0, 0.0}, {0.0}}, 0, 1e-6);
  refused(good, {{0.0}, {}}, 0, 1e-6);
  CHECK_THROWS_AS(heat_stress(good, points, 0, 0.5, 1e-6), std::invalid_argument);
  CHECK_THROWS_AS(heat_displacement({0.5, 0.5, infinity, 0, 0}, points, 1e-6),
                  std::invalid_argument);
}
