// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling of viscoelastic bodies: displacement due to all tractions, and contact.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "samcontact/contact/creeping_contact.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/surface/body_displacement.hpp"
#include "samcontact/operators/surface/creeping_tractions.hpp"

using namespace samcontact;
using operators::CreepingBody;
using operators::MovingCreep;

namespace {

const Grid grid(12, 7, 1e-3, 1.5e-3);
const std::size_t cells = grid.surface_size();

/// Values without any symmetry.
Field uneven(std::size_t size) {
  Field values(size);
  for (std::size_t i = 0; i < size; ++i) values[i] = std::sin(1.0 + 2.3 * static_cast<double>(i));
  return values;
}

/// Components [component][i][j] of a field mirrored at x = 0, with signs.
Field mirrored(const Field& field, std::initializer_list<double> signs) {
  Field out(field.size());
  std::size_t component = 0;
  for (const double sign : signs) {
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const auto at = [&](int row) {
          return component * cells + static_cast<std::size_t>(row) * grid.ny + j;
        };
        out[at(i)] = sign * field[at(grid.nx - 1 - i)];
      }
    }
    ++component;
  }
  return out;
}

void check_equal(const Field& a, const Field& b, double tol) {
  double largest = 0.0, off = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::fabs(b[i]));
    off = std::max(off, std::fabs(a[i] - b[i]));
  }
  CHECK(off <= tol * largest);
}

const Field pressure = uneven(cells), shear = uneven(2 * cells);
const auto upper = operators::half_space({2e7, 0.2}), lower = operators::half_space({1e7, 0.4});

}  // namespace

TEST_SUITE("creeping") {
  TEST_CASE("without creep the displacement is that of elastic bodies") {
    const operators::CreepingTractions bodies(grid, {CreepingBody{upper, {}}, {lower, {}}});
    const operators::Tractions tractions{
        pressure, {shear.begin(), shear.begin() + cells}, {shear.begin() + cells, shear.end()}};
    Field expected(3 * cells, 0.0);
    for (int b = 0; b < 2; ++b) {
      const double sign = operators::shear_sign(b);
      const Field u = operators::BodyDisplacement(grid, b == 0 ? upper : lower)(
          tractions, sign, operators::all_axes);
      for (std::size_t i = 0; i < u.size(); ++i) expected[i] += (i < 2 * cells ? sign : 1.0) * u[i];
    }
    check_equal(bodies.displacement(pressure, shear), expected, 1e-12);
  }

  TEST_CASE("very slow material has crept") {
    const MovingCreep slow{{0.5, 2.0}, {0.0, 1e-12}, false};
    const operators::CreepingTractions bodies(grid, {CreepingBody{upper, {}}, {lower, slow}});
    const operators::CreepingTractions soft(
        grid, {CreepingBody{upper, {}}, {operators::half_space({1e7 / 3.5, 0.4}), {}}});
    check_equal(bodies.displacement(pressure, shear), soft.displacement(pressure, shear), 1e-9);
  }

  TEST_CASE("reversed motion mirrors the displacement") {
    const MovingCreep back{{0.5, 2.0}, {3e-3, 0.2}, false}, forth{{0.5, 2.0}, {3e-3, 0.2}, true};
    const operators::CreepingTractions one(grid, {CreepingBody{upper, back}, {lower, back}});
    const operators::CreepingTractions other(grid, {CreepingBody{upper, forth}, {lower, forth}});
    const Field seen = other.displacement(mirrored(pressure, {1}), mirrored(shear, {-1, 1}));
    check_equal(mirrored(seen, {-1, 1, 1}), one.displacement(pressure, shear), 1e-12);
  }

  TEST_CASE("the gap of all tractions is that of the pressure alone for free rolling") {
    const std::array<CreepingBody, 2> bodies{
        {{upper, {{1.0}, {2e-3}, false}}, {lower, {{3.0}, {1e-2}, false}}}};
    const Field u =
        operators::CreepingTractions(grid, bodies).displacement(pressure, Field(2 * cells, 0.0));
    const contact::CreepingContact contact(grid, {bodies[0], bodies[1]});
    check_equal({u.begin() + 2 * cells, u.end()}, contact.displacement(pressure), 1e-12);
  }
}
