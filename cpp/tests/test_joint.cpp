// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the solution for pressure and shear together that are not accessible from Python.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/contact/joint/joint_solver.hpp"
#include "samcontact/operators/medium/half_space.hpp"

using namespace samcontact;
using contact::Given;

namespace {

struct Stopped : std::exception {};

const operators::TangentialInfluence influence(operators::half_space({4e9, 0.4}),
                                               operators::half_space({2e9, 0.1}));
const Grid grid(11, 9, 1.0, 1.0);
constexpr std::size_t n = 99;

Field sample(std::size_t size) {
  Field f(size);
  for (std::size_t i = 0; i < size; ++i) f[i] = std::sin(1.7 * static_cast<double>(i));
  return f;
}

/// Contact of a paraboloid without slip, pressed and shifted along x.
contact::JointProblem shifted_contact(const contact::JointSolver& solver) {
  const contact::FrictionLaw friction(contact::Coulomb{INFINITY});
  contact::JointProblem problem{.operators = &solver.operators(),
                                .gap = {},
                                .normal = Given::motion(0.4),
                                .cone = contact::FrictionCone(friction),
                                .free_slip = Field(2 * n, 0.0),
                                .motion = Field(2 * n, 0.0)};
  for (const double x : grid.x()) {
    for (const double y : grid.y()) problem.gap.push_back(0.03 * (x * x + y * y));
  }
  std::fill_n(problem.motion.begin(), n, 0.1);
  problem.stiffness = 1 / problem.operators->displacement.tangential_self_influence();
  return problem;
}

std::vector<contact::JointState> start_of(const contact::JointProblem& problem) {
  contact::JointState start = contact::start_from(problem, Field(3 * n, 0.0));
  start.approach = problem.normal.value;
  return {start};
}

}  // namespace

TEST_CASE("the relative displacement is the sum of its parts") {
  const Field tractions = sample(3 * n);
  Field all(3 * n), slid(2 * n), more(2 * n), raised(n);
  ComplexField work;
  operators::RelativeDisplacement(grid, influence).apply(tractions.data(), all.data(), work);
  const operators::NormalTangentialCoupling coupling(grid, influence);
  operators::TangentialDisplacement(grid, influence).apply(&tractions[n], slid.data(), work);
  coupling.tangential(tractions.data(), more.data(), work);
  coupling.normal(&tractions[n], raised.data(), work);
  const auto table = influence.table(operators::Traction::pressure, operators::Axis::z, grid,
                                     operators::CellOffsets::lattice(grid.nx, grid.ny));
  const double scale = *std::max_element(all.begin(), all.end());
  for (std::size_t i = 0; i < n; ++i) {
    double pressed = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const int x = static_cast<int>(i / 9) - static_cast<int>(k / 9),
                y = static_cast<int>(i % 9) - static_cast<int>(k % 9);
      pressed += table[std::abs(y) * grid.nx + std::abs(x)] * tractions[k];
    }
    CHECK(std::fabs(all[i] - pressed - raised[i]) < 1e-13 * scale);
    CHECK(std::fabs(all[n + i] - slid[i] - more[i]) < 1e-13 * scale);
    CHECK(std::fabs(all[2 * n + i] - slid[n + i] - more[n + i]) < 1e-13 * scale);
  }
}

TEST_CASE("Newton steps on pressure and shear end at their maximum number") {
  const contact::JointSolver solver(grid, influence);
  const contact::JointProblem problem = shifted_contact(solver);
  const contact::JointSolution whole =
      contact::JointSolver::solve(problem, start_of(problem), 1e-8, 1000);
  REQUIRE(whole.converged);
  REQUIRE(whole.work.steps > 2);
  const contact::JointSolution cut =
      contact::JointSolver::solve(problem, start_of(problem), 1e-8, 2);
  CHECK_FALSE(cut.converged);
  CHECK(cut.work.steps == 2);
  CHECK(cut.state.error() > whole.state.error());
}

TEST_CASE("pressure and shear together slip along the normal of the ellipse of each cell") {
  const contact::JointSolver solver(grid, influence);
  contact::JointProblem problem = shifted_contact(solver);
  const contact::FrictionLaw law(contact::Anisotropic{0.4, 0.2, 0.5});
  problem.cone = contact::FrictionCone(law);
  contact::CircleCoordinates circle{law.stretch(), Field(n)};
  for (std::size_t i = 0; i < n; ++i) circle.factor[i] = 0.5 + 0.005 * static_cast<double>(i);
  const Field& factor = circle.factor;
  problem.use(circle);
  const contact::JointSolution found =
      contact::JointSolver::solve(problem, start_of(problem), 1e-9, 1000);
  REQUIRE(found.converged);
  Field tractions = found.state.tractions;
  circle.apply(&tractions[n], n);
  // The displacement without the change of coordinates.
  Field displacement(3 * n);
  ComplexField work;
  problem.operators->displacement.apply(tractions.data(), displacement.data(), work);
  const contact::Stretch inverse = law.stretch().inverse();
  int sticking = 0, slipping = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = tractions[i], x = tractions[n + i], y = tractions[2 * n + i];
    if (!(p > 0)) continue;
    const double wx = 0.1 - displacement[n + i], wy = -displacement[2 * n + i];
    const double level = inverse.length(x, y) / (0.4 * factor[i] * p);
    CHECK(level <= 1 + 1e-8);
    if (found.state.states[i] == contact::JointCellState::stick) {
      ++sticking;
      CHECK(std::hypot(wx, wy) < 1e-7);
      continue;
    }
    ++slipping;
    CHECK(level == doctest::Approx(1).epsilon(1e-8));
    const double nx = inverse.x(inverse.x(x, y), inverse.y(x, y)),
                 ny = inverse.y(inverse.x(x, y), inverse.y(x, y));
    CHECK(std::fabs(nx * wy - ny * wx) < 1e-7 * std::hypot(nx, ny));
    CHECK(nx * wx + ny * wy > 0);
  }
  CHECK(sticking > 0);
  CHECK(slipping > 0);
}

TEST_CASE("an interrupt stops Newton steps on pressure and shear") {
  const contact::JointSolver solver(grid, influence);
  const contact::JointProblem problem = shifted_contact(solver);
  set_interrupt_check([] { throw Stopped{}; });
  CHECK_THROWS_AS(for (int k = 0; k < 100000; ++k)
                      contact::JointSolver::solve(problem, start_of(problem), 1e-8, 1000),
                  Stopped);
  set_interrupt_check(nullptr);
  CHECK(contact::JointSolver::solve(problem, start_of(problem), 1e-8, 1000).converged);
}
