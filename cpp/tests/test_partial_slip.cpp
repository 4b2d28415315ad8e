// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the partial-slip solver that are not accessible from Python, each against its
// definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "samcontact/contact/tangential/partial_slip.hpp"
#include "samcontact/contact/tangential/projected_gradient.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/surface/near_tangential.hpp"

using namespace samcontact;
using contact::Given;
using operators::Axis;
using operators::Traction;

namespace {

const auto stiff = operators::half_space({4e9, 0.4});
const auto soft = operators::half_space({2e9, 0.1});
const operators::TangentialInfluence influence(stiff, soft);

Field sample(std::size_t n) {
  Field f(n);
  for (std::size_t i = 0; i < n; ++i) f[i] = std::sin(1.7 * i) + std::cos(0.01 * i);
  return f;
}

double difference(const Field& a, const Field& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

/// Hertz-like pressure over most of a grid, with its maximum off the centre.
Field bump(const Grid& grid) {
  Field pressure;
  for (const double x : grid.x()) {
    for (const double y : grid.y()) {
      const double r2 = (x - 0.05) * (x - 0.05) + 2 * y * y;
      pressure.push_back(r2 < 0.16 ? 1e6 * std::sqrt(0.16 - r2) : 0.0);
    }
  }
  return pressure;
}

contact::ShearTask task_of(const Field& pressure, const contact::TangentialDrive& drive) {
  static const Field none;
  static const contact::FrictionLaw friction(contact::Coulomb{0.3});
  return {pressure, friction, none, none, drive};
}

}  // namespace

TEST_CASE("displacements due to shear and pressure agree with their tables") {
  const Grid grid(7, 5, 1.0, 1.4);
  const int n = 35;
  const Field shear = sample(2 * n), pressure = sample(n);
  Field u(2 * n), raised(n), slid(2 * n);
  ComplexField work;
  operators::TangentialDisplacement(grid, influence).apply(shear.data(), u.data(), work);
  const operators::NormalTangentialCoupling coupling(grid, influence);
  REQUIRE(coupling.is_on());
  coupling.normal(shear.data(), raised.data(), work);
  coupling.tangential(pressure.data(), slid.data(), work);

  const auto sum = [&](Traction traction, Axis axis, const double* load, int at) {
    double total = 0.0;
    for (int from = 0; from < n; ++from) {
      const int i = at / 5 - from / 5, j = at % 5 - from % 5;
      const auto parity = operators::compliance_parity(traction, axis);
      const double sign =
          (parity.odd_x && i < 0 ? -1.0 : 1.0) * (parity.odd_y && j < 0 ? -1.0 : 1.0);
      const auto here = operators::CellOffsets{{std::abs(i)}, {std::abs(j)}};
      total += sign * influence.table(traction, axis, grid, here)[0] * load[from];
    }
    return total;
  };
  for (const int at : {0, 12, 34}) {
    CHECK(u[at] == doctest::Approx(sum(Traction::shear_x, Axis::x, shear.data(), at) +
                                   sum(Traction::shear_y, Axis::x, &shear[n], at)));
    CHECK(u[n + at] == doctest::Approx(sum(Traction::shear_x, Axis::y, shear.data(), at) +
                                       sum(Traction::shear_y, Axis::y, &shear[n], at)));
    CHECK(raised[at] == doctest::Approx(sum(Traction::shear_x, Axis::z, shear.data(), at) +
                                        sum(Traction::shear_y, Axis::z, &shear[n], at)));
    CHECK(slid[at] == doctest::Approx(sum(Traction::pressure, Axis::x, pressure.data(), at)));
  }
  // Betti's theorem: normal displacement due to shear and tangential displacement due to pressure.
  CHECK(contact::dot(raised, pressure) == doctest::Approx(contact::dot(slid, shear)));
  // Identical materials have neither.
  CHECK_FALSE(operators::NormalTangentialCoupling(grid, {soft, soft}).is_on());
}

TEST_CASE(
    "the approximate tangential displacement is exact on small boxes and close on large ones") {
  const auto largest_error = [](const Grid& grid) {
    const Field shear = sample(2 * grid.surface_size());
    Field exact(shear.size()), cheap(shear.size());
    ComplexField work;
    operators::TangentialDisplacement(grid, influence).apply(shear.data(), exact.data(), work);
    operators::NearTangential(grid, influence).apply(shear.data(), cheap.data(), work);
    return difference(exact, cheap) / contact::longest(exact);
  };
  CHECK(largest_error(Grid(12, 31, 1.0, 1.3)) < 1e-14);
  // Across the seam the crossed coefficient, which is odd, has a step.
  CHECK(largest_error(Grid(64, 64, 1.0, 1.3)) < 6e-3);
  CHECK(largest_error(Grid(130, 75, 1.0, 1.3)) < 6e-3);
  CHECK(largest_error(Grid(96, 70, 1.0, 1.3).made_periodic(true, true)) < 1e-14);
  CHECK(largest_error(Grid(96, 70, 1.0, 1.3).made_periodic(false, true)) < 6e-3);
}

TEST_CASE("the preconditioner inverts the tangential displacement of a packet of waves") {
  const contact::ShearOperators operators(Grid(64, 64, 1.0, 1.0), influence);
  Field packet, back(2 * 64 * 64);
  for (const double amplitude : {1.0, -0.6}) {
    for (int i = 0; i < 64; ++i) {
      for (int j = 0; j < 64; ++j) {
        const double x = i - 31.5, y = j - 31.5;
        packet.push_back(amplitude * std::cos(0.8 * x + 0.5 * y) *
                         std::exp(-(x * x + y * y) / 100));
      }
    }
  }
  ComplexField work;
  operators.displacement.apply(packet.data(), back.data(), work);
  operators.preconditioner.apply(back.data(), back.data(), work);
  CHECK(difference(packet, back) < 0.01);
}

TEST_CASE("projected gradients find the same shear; the energy gap bounds the error") {
  const Grid grid(24, 20, 1.0 / 24, 1.0 / 20);
  const Field pressure = bump(grid);
  const contact::ShearOperators operators(grid, influence);
  contact::ShearProblem problem;
  problem.operators = &operators;
  problem.box_size = grid.surface_size();
  Field along_x, along_y;
  for (std::size_t at = 0; at < pressure.size(); ++at) {
    if (pressure[at] <= 0) continue;
    problem.cells.push_back(at);
    problem.bound.push_back(0.3 * pressure[at]);
  }
  const std::size_t m = problem.size();
  problem.free_slip.assign(2 * m, 0.0);
  double whole = 0.0;
  for (std::size_t c = 0; c < m; ++c) {
    whole += problem.bound[c];
    problem.free_slip[m + c] = 1e-6 * c / m;
  }
  along_x.assign(2 * m, 0.0);
  std::fill_n(along_x.begin(), m, 1.0);
  problem.modes.push_back({along_x, 0.7 * whole});
  problem.stiffness = 1e9;
  problem.smallest_shear = 1e-6;
  contact::ShearApplier applier(problem);
  const auto newton = contact::solve_partial_slip(problem, applier, {}, 1e-11, 60);
  CHECK(newton.converged);
  CHECK(newton.fallbacks == 0);
  const auto slipping = std::count(newton.slipping.begin(), newton.slipping.end(), 1);
  CHECK(slipping > 10);
  CHECK(slipping < static_cast<std::ptrdiff_t>(m) - 10);

  contact::ShearResult slow{Field(2 * m, 0.0), Field(2 * m), {}, {0.0}};
  for (int n = 0; n < 6; ++n) {
    contact::projected_gradient(problem, applier, 1e-9, 40, slow);
    Field off = slow.shear, displacement(2 * m);
    contact::add_scaled(-1.0, newton.shear, off);
    applier.displacement(off, displacement);
    CHECK(contact::dot(off, displacement) <
          contact::energy_gap(problem, slow.shear, slow.slip) + 1e-12);
  }
  CHECK(difference(slow.shear, newton.shear) < 1e-6 * 0.3 * 4e5);
  CHECK(slow.motion[0] == doctest::Approx(newton.motion[0]).epsilon(1e-6));
}

TEST_CASE("forces above the bounds have no projection") {
  const Grid grid(8, 8, 1.0 / 8, 1.0 / 8);
  const contact::ShearOperators operators(grid, influence);
  contact::ShearProblem problem;
  problem.operators = &operators;
  problem.box_size = 64;
  problem.cells = {9, 10, 11};
  problem.bound = {1.0, 2.0, 3.0};
  problem.free_slip.assign(6, 0.0);
  problem.smallest_shear = 1e-9;
  problem.modes.push_back({{1, 1, 1, 0, 0, 0}, 5.0});
  Field shear{0.5, 0.0, -1.0, 1.0, 0.5, 3.0};
  std::vector<double> multipliers{0.0};
  CHECK(contact::project(problem, shear, multipliers));
  CHECK(shear[0] + shear[1] + shear[2] == doctest::Approx(5.0));
  // From a start with all cells cut, on either side.
  for (const double target : {-5.999, -5.0, 1e-2, 5.999}) {
    for (const double from : {-1e3, -7.0, 7.0, 1e3}) {
      problem.modes[0].target = target;
      shear = {from, from, from, 0.0, 0.0, 0.0};
      multipliers = {0.0};
      CHECK(contact::project(problem, shear, multipliers));
      CHECK(shear[0] + shear[1] + shear[2] == doctest::Approx(target));
    }
  }
  problem.modes[0].target = 6.1;
  CHECK_FALSE(contact::project(problem, shear, multipliers));
}

TEST_CASE("starts from coarse boxes save applications on the finest and do not change the result") {
  const Grid grid(96, 80, 1.0 / 96, 1.0 / 80);
  const Field pressure = bump(grid);
  const contact::ShearSolver solver(grid, influence);
  double load = 0.0;
  for (const double p : pressure) load += p * grid.cell_area();
  const contact::TangentialDrive drive{Given::force(0.2 * load), Given::force(-0.1 * load),
                                       Given::motion(1e-5)};
  const auto nested = solver.solve(task_of(pressure, drive), {}, {}, 1e-8, 60);
  CHECK(nested.converged);
  CHECK(nested.operator_applications <= 8);
  CHECK(nested.friction_work > 0);
  CHECK(nested.force[0] == doctest::Approx(0.2 * load));
  CHECK(nested.force[1] == doctest::Approx(-0.1 * load));
  const auto plain =
      solver.solve(task_of(pressure, drive), Field(2 * pressure.size(), 0.0), {}, 1e-8, 60);
  CHECK(plain.converged);
  CHECK(difference(plain.shear, nested.shear) < 1e-6 * 0.3 * 4e5);
  for (int k = 0; k < 2; ++k) CHECK(plain.motion[k] == doctest::Approx(nested.motion[k]));
  // Prescribing the motion that follows from the forces gives the same forces.
  const contact::TangentialDrive moved{Given::motion(nested.motion[0]),
                                       Given::motion(nested.motion[1]), Given::motion(1e-5)};
  const auto back = solver.solve(task_of(pressure, moved), {}, {}, 1e-8, 60);
  for (int k = 0; k < 3; ++k) {
    CHECK(back.force[k] == doctest::Approx(nested.force[k]).epsilon(1e-5));
  }
}
