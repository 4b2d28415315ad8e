// SPDX-License-Identifier: GPL-3.0-or-later
// The core without Python: acceleration, interruption, and one small elastic-plastic problem.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/stress_fields.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"

using namespace samcontact;
using namespace samcontact::simulation;

namespace {

const Settings usual{.tol = 1e-6,
                     .increment_tol = 0.0,
                     .max_iterations = 60,
                     .on_border = contact::OnBorder::error,
                     .residual_stress = operators::ResidualMethod::fast,
                     .image_tol = 1e-3,
                     .reach = 0};

struct Stopped : std::exception {};

Simulation small_setup(const plasticity::Material& lower, const Settings& settings = usual) {
  const bool layered = lower.is_plastic();
  const Grid grid(17, 15, 60e-6, 60e-6, layered ? 12 : 0, layered ? 60e-6 : 0.0);
  Field gap(grid.surface_size());
  const auto x = grid.x(), y = grid.y();
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      gap[i * grid.ny + j] = (x[i] * x[i] + y[j] * y[j]) / (2 * 7.5e-3);
    }
  }
  return Simulation(grid, plasticity::Material::make_elastic(210e9, 0.3), lower, gap,
                    contact::FrictionLaw(contact::FullSliding{0.0}), settings);
}

Target load(double newton) { return {.drive = contact::Drive::load(newton)}; }

}  // namespace

TEST_CASE("Anderson mixing solves a linear problem of size n in n + 1 residuals") {
  // To the single precision of its history; further ones reach rounding. x = A x + b with a
  // contraction for which plain iteration needs hundreds of steps.
  constexpr int n = 5;
  const auto residual = [](const Field& x) {
    Field f(n);
    for (int i = 0; i < n; ++i) {
      f[i] = (0.2 * i + 0.15) * x[i] + 0.01 * x[(i + 1) % n] + (1 + i) - x[i];
    }
    return f;
  };
  contact::Anderson anderson(n);
  Field x(n, 0.0);
  for (int k = 0; k <= n; ++k) anderson.next(x, residual(x));
  CHECK(contact::norm(residual(x)) < 1e-6 * contact::norm(x));
  for (int k = 0; k < 3; ++k) anderson.next(x, residual(x));
  CHECK(contact::norm(residual(x)) < 1e-12 * contact::norm(x));
}

TEST_CASE("the ordered sum omits and repeats no terms") {
  for (const std::size_t n : {0u, 1u, 8191u, 8192u, 8193u, 100000u}) {
    CHECK(ordered_sum(n, [](std::size_t) { return 1.0; }) == static_cast<double>(n));
  }
}

TEST_CASE("the rounding error of the ordered sum is that of short sums") {
  // Mean of equal terms; if they are added one after the other, its error is 1e-13.
  for (const std::size_t n : {1000u, 4096u, 8192u, 1000000u}) {
    const double mean = ordered_sum(n, [](std::size_t) { return 0.1; }) / static_cast<double>(n);
    CHECK(std::fabs(mean / 0.1 - 1) < 1e-14);
  }
}

TEST_CASE("an elastic problem accepts the smallest tolerance") {
  Settings settings = usual;
  settings.tol = 1e-11;
  auto simulation = small_setup(plasticity::Material::make_elastic(210e9, 0.3), settings);
  CHECK(simulation.step(load(300.0)).load == 300.0);
}

TEST_CASE("loading causes plastic flow, unloading preserves the imprint") {
  auto simulation = small_setup(
      plasticity::Material::with_law(210e9, 0.3, plasticity::LinearHardening{1e9, 21e9}));
  const State loaded = simulation.step(load(300.0));
  CHECK(loaded.plastic_iterations > 0);
  CHECK(loaded.yield_excess <= 1e-6);
  const double sum =
      std::accumulate(loaded.tractions.pressure.begin(), loaded.tractions.pressure.end(), 0.0);
  CHECK(sum * 60e-6 * 60e-6 == doctest::Approx(300.0).epsilon(1e-9));
  const State unloaded = simulation.step(load(0.0));
  CHECK(contact::norm(unloaded.tractions.pressure) == 0.0);
  const Field print = residual_displacement(unloaded, 1, operators::Axis::z);
  CHECK(print[8 * 15 + 7] > 0);
}

TEST_CASE("an elastic problem needs no volume operators") {
  auto simulation = small_setup(plasticity::Material::make_elastic(210e9, 0.3));
  simulation.step(load(300.0));
  CHECK(simulation.volume_bytes() == 0);
  CHECK(simulation.counters().yield_checks == 0);
  CHECK_THROWS_AS(stress(simulation.state(), 1), std::invalid_argument);
}

TEST_CASE("an interrupt leaves the state unchanged") {
  auto simulation =
      small_setup(plasticity::Material::with_law(210e9, 0.3, plasticity::PerfectPlastic{1e9}));
  const State before = simulation.step(load(100.0));
  set_interrupt_check([] { throw Stopped{}; });
  CHECK_THROWS_AS(for (int n = 0; n < 100000; ++n) simulation.step(load(n % 2 ? 250.0 : 200.0)),
                  Stopped);
  set_interrupt_check(nullptr);
  const double reached = simulation.state().load;
  CHECK((reached == 100.0 || reached == 200.0 || reached == 250.0));
  CHECK(simulation.step(load(250.0)).converged);
}

TEST_CASE("a gap with an end moves to the nearest cell, and a plane remains a plane") {
  const Grid grid(12, 2, 1.0, 1.0);
  const auto at = [](double x, int j) { return 3.0 + 0.5 * x + j; };
  Field gap(grid.surface_size());
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      const bool is_body = i >= 3 && i != 7 && i < 10;
      gap[i * grid.ny + j] = is_body ? at(i, j) : INFINITY;
    }
  }
  for (const double shift : {0.3, -0.3, 0.7, -2.4}) {
    const Field moved = shifted_gap(gap, grid, shift);
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const double x = std::clamp(i - shift, 0.0, grid.nx - 1.0);
        const int nearest = static_cast<int>(std::lround(x));
        const double there = gap[nearest * grid.ny + j], found = moved[i * grid.ny + j];
        CHECK(std::isinf(found) == std::isinf(there));
        CHECK(found > 0);  // neither -inf nor NaN
        if (!std::isfinite(there)) continue;
        // next to an end the height of the nearest cell, at most half a cell away
        CHECK(std::fabs(found - at(x, j)) <= 0.25 + 1e-12);
        const bool between = nearest > 3 && nearest < 6;
        if (between) CHECK(found == doctest::Approx(at(x, j)));
      }
    }
  }
}
