// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of time of a viscoelastic body: coefficients of the exact recursion.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "samcontact/simulation/sources/traction_memory.hpp"

using namespace samcontact;
using simulation::RelaxationStep;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Relaxation three_terms{{1e-3, 1.0, 1e4}, {0.3, 0.4, 0.2}};

/// One point of the surface, advanced by the recursion.
struct Point {
  double equivalent = 0.0;
  std::vector<double> fading = std::vector<double>(three_terms.terms(), 0.0);

  /// Traction at the end of a step in which the equivalent traction rises linearly.
  double rise(double change, double duration) {
    const RelaxationStep step(three_terms, duration);
    equivalent += change;
    double traction = three_terms.long_time_share() * equivalent;
    for (std::size_t i = 0; i < three_terms.terms(); ++i) {
      fading[i] = step.decay[i] * fading[i] + step.mean[i] * change;
      traction += three_terms.shares[i] * fading[i];
    }
    return traction;
  }
};

/// Traction at a time after the start of a steady rise: the integral of the relaxation.
double during_ramp(double rate, double time) {
  double sum = three_terms.long_time_share() * time;
  for (std::size_t i = 0; i < three_terms.terms(); ++i) {
    const double tau = three_terms.times[i];
    sum -= three_terms.shares[i] * tau * std::expm1(-time / tau);
  }
  return rate * sum;
}

}  // namespace

TEST_CASE("the recursion is exact for equivalent tractions linear in each step") {
  Point point;
  double time = 0.0;
  for (const double duration : {1e-9, 2e-4, 3e-3, 0.7, 40.0, 1e5}) {
    time += duration;
    const double traction = point.rise(5.0 * duration, duration);
    CHECK(traction == doctest::Approx(during_ramp(5.0, time)).epsilon(1e-13));
  }
  // The rise ends: what it left fades.
  const double left = during_ramp(5.0, time + 2e4) - during_ramp(5.0, 2e4);
  CHECK(point.rise(0.0, 2e4) == doctest::Approx(left).epsilon(1e-12));
}

TEST_CASE("the compliance of a step is that of its mean modulus") {
  for (const double duration : {1e-6, 1e-3, 0.5, 1e3, 1e7}) {
    const RelaxationStep step(three_terms, duration);
    CHECK(step.compliance == doctest::Approx(duration / during_ramp(1.0, duration)).epsilon(1e-13));
  }
  CHECK(RelaxationStep(three_terms, 0.0).compliance == 1.0);
  CHECK(RelaxationStep(three_terms, infinity).compliance == doctest::Approx(10.0).epsilon(1e-14));
}

TEST_CASE("means and lags keep their digits in short and long steps") {
  const Relaxation one{{1.0}, {0.5}};
  for (double x = 1e-12; x < 1e12; x *= 1.7) {
    const RelaxationStep step(one, x);
    // (1 - mean)/x, from the integral of the mean: continued by its series where it cancels
    double lag = 0.0, term = 0.5;
    if (x < 1) {
      for (int n = 3; n < 25; term *= -x / n++) lag += term;
    } else {
      lag = (1.0 + std::expm1(-x) / x) / x;
    }
    CHECK(step.lag[0] == doctest::Approx(lag).epsilon(1e-10));
    CHECK(step.mean[0] == doctest::Approx(1.0 - x * lag).epsilon(x < 1 ? 1e-13 : 1e-10));
    CHECK(step.decay[0] == std::exp(-x));
  }
}

TEST_CASE("a fluid has no long-time state") {
  const Relaxation fluid{{1.0, 2.0}, {0.4, 0.6}};
  CHECK(RelaxationStep(fluid, 1e6).compliance > 1e5);
  CHECK_THROWS_AS(RelaxationStep(fluid, infinity), std::invalid_argument);
}
