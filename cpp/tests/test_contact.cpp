// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the contact solver that are not accessible from Python, each against its definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "samcontact/contact/normal/coarsening.hpp"
#include "samcontact/contact/normal/multilevel.hpp"
#include "samcontact/contact/normal/polonsky_keer.hpp"
#include "samcontact/contact/normal/preconditioner.hpp"
#include "samcontact/contact/normal/window.hpp"
#include "samcontact/operators/medium/half_space.hpp"

using namespace samcontact;

namespace {

/// With a normal compliance of 1e-9/Pa.
const operators::SurfaceInfluence influence = [] {
  operators::SurfaceInfluence sum;
  sum.add(operators::half_space({1e9, 0.0}));
  return sum;
}();

Field sample(std::size_t n) {
  Field f(n);
  for (std::size_t i = 0; i < n; ++i) f[i] = 2 + std::sin(1.7 * i) + std::cos(0.01 * i);
  return f;
}

double largest_difference(const Field& a, const Field& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

double largest(const Field& f) { return *std::max_element(f.begin(), f.end()); }

/// A wavy ball on nx x ny cells.
Field wavy_gap(const Grid& grid) {
  Field gap;
  for (const double x : grid.x()) {
    for (const double y : grid.y()) {
      gap.push_back((x * x + y * y) / 2e3 + 0.02 * std::cos(2.1 * x) * std::cos(1.3 * y));
    }
  }
  return gap;
}

struct Displacements {
  Field exact, cheap;
};

Displacements displacements(const Grid& grid, const Field& pressure) {
  ComplexField work;
  Displacements u{Field(pressure.size()), Field(pressure.size())};
  operators::SurfaceDisplacement(grid, influence).apply(pressure.data(), u.exact.data(), work);
  operators::NearDisplacement(grid, influence).apply(pressure.data(), u.cheap.data(), work);
  return u;
}

}  // namespace

TEST_CASE("the approximate displacement is exact on small boxes and close on large ones") {
  for (const auto& [nx, ny, tol] :
       {std::tuple{12, 31, 1e-14}, {63, 90, 1e-14}, {64, 64, 1e-3}, {130, 75, 1e-3}}) {
    const Grid grid(nx, ny, 1.0, 1.3);
    const auto u = displacements(grid, sample(grid.surface_size()));
    CHECK(largest_difference(u.exact, u.cheap) < tol * largest(u.exact));
  }
}

TEST_CASE("the approximate displacement is exact on a whole periodic grid and close on a part") {
  for (const auto& [along_x, along_y] : {std::pair{true, true}, {false, true}, {true, false}}) {
    const Grid grid = Grid(128, 96, 1.0, 1.3).made_periodic(along_x, along_y);
    const auto whole = displacements(grid, sample(grid.surface_size()));
    const bool both = along_x && along_y;
    CHECK(largest_difference(whole.exact, whole.cheap) <
          (both ? 1e-14 : 1e-3) * largest(whole.exact));
    const Grid part = Box{0, 0, 70, 66, 0}.grid(grid);
    const auto some = displacements(part, sample(part.surface_size()));
    CHECK(largest_difference(some.exact, some.cheap) < 2e-3 * largest(some.exact));
  }
}

TEST_CASE("the preconditioner inverts the displacement of a Fourier mode on the periodic grid") {
  const contact::NearOperators near(Grid(64, 64, 1.0, 1.0), influence, nullptr);
  // In the middle of the box a packet of waves is hardly affected by the edges.
  Field packet, back(64 * 64), displacement(64 * 64);
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const double x = i - 31.5, y = j - 31.5;
      packet.push_back(std::cos(0.8 * x) * std::exp(-(x * x + y * y) / 100));
    }
  }
  ComplexField work;
  near.displacement.apply(packet.data(), displacement.data(), work);
  near.preconditioner.apply(displacement.data(), back.data(), work);
  CHECK(largest_difference(packet, back) < 0.01);
}

TEST_CASE("coarsening preserves the mean, and refining preserves constants") {
  const Grid grid(10, 8, 1.0, 2.0), coarse = contact::coarsened(grid);
  CHECK(coarse.nx == 5);
  CHECK(coarse.ny == 4);
  CHECK(coarse.cell_area() == 4 * grid.cell_area());
  const Field field = sample(80), half = contact::coarsened(grid, field);
  double sum = 0.0, coarse_sum = 0.0;
  for (const double f : field) sum += f;
  for (const double f : half) coarse_sum += 4 * f;
  CHECK(coarse_sum == doctest::Approx(sum));
  const Grid odd(7, 9, 1.0, 1.0);
  const Field constant = contact::refined(odd, contact::coarsened(odd, Field(63, 3.0)));
  CHECK(largest_difference(constant, Field(63, 3.0)) < 1e-15);
}

TEST_CASE("refining is linear interpolation between centres") {
  const Grid grid(12, 6, 1.0, 1.0);
  Field linear;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 6; ++j) linear.push_back(2.0 * i - 3.0 * j);
  }
  const Field refined = contact::refined(grid, contact::coarsened(grid, linear));
  for (int i = 1; i < 11; ++i) {
    for (int j = 1; j < 5; ++j) CHECK(refined[i * 6 + j] == doctest::Approx(linear[i * 6 + j]));
  }
}

TEST_CASE("the contact region contains pressure and penetration, and has a margin") {
  const Grid grid(300, 200, 1.0, 1.0);
  const Box all = Box::surface(grid);
  Field pressure(grid.surface_size(), 0.0), gap(grid.surface_size(), 1.0);
  CHECK(contact::possible_contact(grid, pressure, gap) == all);
  pressure[50 * grid.ny + 190] = 1.0;
  gap[60 * grid.ny + 199] = -1.0;
  const Box tight = contact::possible_contact(grid, pressure, gap);
  CHECK(tight == Box{50, 190, 11, 10, 1});

  const Box window = contact::with_margin(grid, tight, {});
  CHECK(window == Box{24, 136, 64, 64, 1});
  CHECK(window.contains(tight));

  const Box grown = contact::with_margin(grid, {10, 150, 20, 20, 1}, window);
  CHECK(grown.contains(window));
  CHECK(grown.contains({10, 150, 20, 20, 1}));
  CHECK_FALSE(grown == all);
  CHECK(contact::with_margin(grid, {0, 0, 250, 180, 1}, {}) == all);
}

TEST_CASE("the active-set iteration agrees with the plain conjugate gradient") {
  for (const auto& [nx, ny] : {std::pair{40, 30}, {90, 70}}) {
    const Grid grid(nx, ny, 1.0, 1.0);
    const Field gap = wavy_gap(grid);
    const operators::SurfaceDisplacement displacement(grid, influence);
    const contact::Multilevel multilevel(grid, influence);
    const std::vector<contact::Drive> drives{
        contact::Drive::load(1e8),
        contact::Drive::approach(0.05),
        {contact::Given::force(1e8), {contact::Given::force(2e8), contact::Given::force(-1e8)}}};
    for (const contact::Drive& drive : drives) {
      const Field none(gap.size(), 0.0);
      const auto fast = multilevel.solve(gap, drive, none, 1e-10, 1000);
      const auto plain = contact::polonsky_keer(displacement, gap, contact::RigidModes(drive, grid),
                                                none, 1e-10, 1000);
      CHECK(fast.converged);
      CHECK(plain.converged);
      CHECK(largest_difference(fast.tractions.pressure, plain.tractions.pressure) <
            1e-7 * largest(plain.tractions.pressure));
      CHECK(fast.operator_applications < plain.operator_applications / 2);
    }
  }
}

TEST_CASE("too few iterations are reported") {
  const Grid grid(40, 40, 1.0, 1.0);
  const contact::Multilevel multilevel(grid, influence);
  const auto solution = multilevel.solve(wavy_gap(grid), contact::Drive::load(1e8),
                                         Field(grid.surface_size(), 0.0), 1e-10, 2);
  CHECK_FALSE(solution.converged);
  CHECK(solution.iterations == 2);
  CHECK(solution.error > 1e-10);
}
