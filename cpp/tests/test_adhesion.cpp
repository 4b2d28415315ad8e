// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of adhesion against numerical integrals, and the descent of the energy.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/laws/adhesion.hpp"
#include "samcontact/contact/normal/adhesive_contact.hpp"
#include "samcontact/contact/normal/gap_descent.hpp"
#include "samcontact/operators/medium/half_space.hpp"

using namespace samcontact;
using namespace samcontact::contact;

namespace {

std::vector<SharedContactLaw> laws() {
  return {exponential_adhesion(0.3, 0.7), dugdale_adhesion(0.3, 0.5, 0.2),
          dugdale_adhesion(0.3, 0.5, 1.2), lennard_jones_adhesion(0.3, 0.9),
          tabulated_adhesion({0.0, 0.1, 0.4, 0.6, 1.0, 0.0})};
}

operators::SurfaceInfluence soft() {
  operators::SurfaceInfluence sum;
  sum.add(operators::half_space({1e9, 0.3}));
  return sum;
}

Field rough_ball(const Grid& grid, double radius, double height) {
  Field gap;
  for (const double x : grid.x()) {
    for (const double y : grid.y()) {
      const double noise = 0.5 + 0.5 * std::sin(40.0 * static_cast<double>(gap.size()));
      gap.push_back((x * x + y * y) / (2 * radius) + noise * height);
    }
  }
  return gap;
}

}  // namespace

TEST_CASE("energy and fall of a law are the integral and the slope of its attraction") {
  for (const auto& law : laws()) {
    double integral = 0.0, steepest = 0.0, largest = 0.0;
    const double step = 1e-4;
    for (double g = 0.5 * step; g < 6.0; g += step) {
      integral += step * law->attraction(g);
      const double h = 1e-6;
      const double slope = (law->attraction(g - h) - law->attraction(g + h)) / (2 * h);
      steepest = std::max(steepest, slope);
      largest = std::max(largest, law->attraction(g));
      if (std::fabs(std::remainder(g, 0.1)) > 2 * step) {  // kinks of a table
        CHECK(law->fall(g) == doctest::Approx(slope).epsilon(1e-4));
        CHECK(law->energy(g + 0.5 * step) == doctest::Approx(integral).epsilon(1e-4));
      }
    }
    CHECK(law->steepest_fall() == doctest::Approx(steepest).epsilon(1e-3));
    CHECK(law->largest_attraction() == doctest::Approx(largest).epsilon(1e-3));
    CHECK(law->attraction(law->reach()) <= 3e-9 * law->largest_attraction());
    CHECK(law->attraction(INFINITY) == 0.0);
    CHECK(law->energy(INFINITY) == 0.0);
    CHECK(law->varies());
  }
}

TEST_CASE("friction by compression is the pressure of cells that are pressed") {
  const auto law = exponential_adhesion(0.3, 0.5);
  const auto pressing = rubbing_by_compression(law);
  const Field pushed{0.0, 0.4, 0.9}, gap{0.2, 0.0, 0.0};
  CHECK(rubbing_pressure(*law, pushed, gap) == pushed);
  CHECK(rubbing_pressure(*pressing, pushed, gap) == Field{0.0, 0.0, 0.9 - 0.6});
  CHECK(pressing->varies());
  CHECK(pressing->attraction(0.1) == law->attraction(0.1));
}

TEST_CASE("impossible laws of adhesion are refused") {
  CHECK_THROWS_AS(exponential_adhesion(0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(dugdale_adhesion(0.3, 0.5, 1.3), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_adhesion({0.0, 1.0}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_adhesion({0.1, 1.0, 1.0, 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_adhesion({0.0, 1.0, 1.0, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_adhesion({0.0, 0.0, 1.0, 0.0}), std::invalid_argument);
}

TEST_CASE("the descent never increases the energy, and the stiffness inverts the compliance") {
  for (const char* periodic : {"", "xy"}) {
    Grid grid(24, 20, 1e-8, 1.2e-8);
    if (*periodic) grid.period = {24, 20};
    const AdhesiveSurface surface(grid, soft());
    ComplexField work;
    Field p(surface.size(), 0.0), u = p, back = p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = std::sin(1.3 * static_cast<double>(i));
    surface.displace(p, u, work);
    surface.press(u, back, work);
    double mean = 0.0;
    for (const double value : p) mean += value / static_cast<double>(p.size());
    const double kept = surface.has_free_mean() ? mean : 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      CHECK(back[i] == doctest::Approx(p[i] - kept).epsilon(1e-9));
    }
    const double range = std::sqrt(0.05 * surface.self_influence() / 0.5);
    const auto law = exponential_adhesion(0.05, range);
    const Field gap = rough_ball(grid, 1e-6, 2e-9);
    GapDescent descent(surface, *law, gap);
    descent.start_from({});
    for (const double approach : {0.0, 1e-9, 2e-9, 0.0, -2e-9, -4e-9, -8e-9}) {
      CHECK(descent.descend(approach, 1e-9, 400));
      CHECK(descent.energy_rise() < 1e-12);
    }
  }
}

TEST_CASE("a load is reached on the branch of its start, or refused with the largest tension") {
  const Grid grid(32, 32, 8e-9, 8e-9);
  const auto influence = soft();
  const double range = std::sqrt(0.05 * AdhesiveSurface(grid, influence).self_influence() / 0.5);
  const AdhesiveContact contact(grid, influence, exponential_adhesion(0.05, range));
  const Field gap = rough_ball(grid, 1e-6, 0.0), none(grid.surface_size(), 0.0);
  const Solution pressed = contact.solve(gap, Drive::load(1e-7), none, 1e-9, 2000);
  CHECK(pressed.converged);
  CHECK(pressed.load == 1e-7);
  const Solution again =
      contact.solve(gap, Drive::approach(pressed.motion.approach), none, 1e-9, 2000);
  CHECK(again.load == doctest::Approx(1e-7).epsilon(1e-6));
  double largest = 0.0, where = 0.0;
  try {
    contact.solve(gap, Drive::load(-1e-5), pressed.tractions.pressure, 1e-9, 2000);
    FAIL("the tension is larger than any adhesion bears");
  } catch (const PullOffError& error) {
    largest = error.force();
    where = error.approach();
  }
  CHECK(largest > 1.5 * 3.14159 * 0.05 * 1e-6);
  CHECK(largest < 2.0 * 3.14159 * 0.05 * 1e-6);
  const Solution held =
      contact.solve(gap, Drive::load(-0.99 * largest), pressed.tractions.pressure, 1e-9, 2000);
  CHECK(held.motion.approach > where);
}
