// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_source.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact::kernels {
namespace {

void check_ascending(const std::vector<double>& x, const char* name) {
  if (x.empty()) throw std::invalid_argument(std::string(name) + " must not be empty");
  for (std::size_t i = 0; i < x.size(); ++i) {
    require(std::isfinite(x[i]) && (i == 0 || x[i] > x[i - 1]), name,
            "finite and strictly ascending", x[i]);
  }
}

}  // namespace

bool HeatSource::is_steady() const { return std::isinf(heated); }
double HeatSource::speed() const { return std::hypot(speed_x, speed_y); }

bool nothing_yet(const HeatSource& source) {
  return source.heated < 1e-100 * std::min(source.a, source.b) * std::min(source.a, source.b);
}

void check_heat_arguments(const HeatSource& source, const HeatPoints& points, double z,
                          double tol) {
  require(source.a > 0 && std::isfinite(source.a), "a", "finite and > 0", source.a);
  require(source.b > 0 && std::isfinite(source.b), "b", "finite and > 0", source.b);
  // Larger numbers overflow, and have no practical meaning.
  const double longest = 1e60 * source.a * source.a;
  require(source.heated >= 0 && (source.is_steady() || source.heated <= longest), "heated",
          "in [0, 1e60 a^2] or infinite", source.heated);
  require(!source.is_moving() || source.speed() * source.a >= 1e-60, "speed", "0 or >= 1e-60/a",
          source.speed());
  const auto check_period = [&](double period, double size, double speed) {
    require(period == 0 || (std::isfinite(period) && period >= size * (1 - 1e-12)), "period",
            "0, or finite and >= the size of the source", period);
    require(period == 0 || (!source.is_steady() && speed == 0), "period",
            "0 for a steady source and along its motion", period);
  };
  check_period(source.period_x, 2 * source.a, source.speed_x);
  check_period(source.period_y, 2 * source.b, source.speed_y);
  require(z >= 0 && std::isfinite(z), "z", "finite and >= 0", z);
  require(tol >= 1e-12 && tol <= 1e-2, "tol", "in [1e-12, 1e-2]", tol);
  check_ascending(points.x, "x");
  check_ascending(points.y, "y");
  const double extent =
      std::max({std::fabs(points.x.front()), std::fabs(points.x.back()),
                std::fabs(points.y.front()), std::fabs(points.y.back()), source.a, source.b});
  require(source.speed() <= max_heat_path / extent, "speed",
          "at most 1e7 over the largest of a, b, |x| and |y|, " + to_text(max_heat_path / extent),
          source.speed());
}

}  // namespace samcontact::kernels
