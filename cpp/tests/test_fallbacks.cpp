// SPDX-License-Identifier: GPL-3.0-or-later
// Fallbacks of partial-slip iterations that do not converge, provoked by an incorrect approximate
// operator, and the linear solver of rolling.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "samcontact/contact/iteration/gmres.hpp"
#include "samcontact/contact/tangential/partial_slip.hpp"
#include "samcontact/contact/tangential/steady_rolling.hpp"
#include "samcontact/operators/medium/half_space.hpp"

using namespace samcontact;

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

const auto body = operators::half_space({4e9, 0.3});
const auto much_stiffer = operators::half_space({40e9, 0.3});

contact::LinearMap map_of(const Matrix& matrix) {
  return [&matrix](const Field& v, Field& out) {
    const auto n = static_cast<Eigen::Index>(v.size());
    out.resize(v.size());
    Eigen::Map<Vector>(out.data(), n) = matrix * Eigen::Map<const Vector>(v.data(), n);
  };
}

/// Round contact on a grid with rows ahead, with a given slip of each cell.
struct Setup {
  Grid grid{20 + contact::rolling_margin, 18, 1.0 / 20, 1.0 / 18};
  contact::ShearOperators operators{grid, {body, body}};
  contact::ShearProblem problem;

  explicit Setup(double slip_x, double slip_y) {
    problem.operators = &operators;
    problem.box_size = grid.surface_size();
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 18; ++j) {
        const double x = (i - 9.5) / 20, y = (j - 8.5) / 18, r2 = x * x + y * y;
        if (r2 >= 0.16) continue;
        problem.cells.push_back(static_cast<std::size_t>(i) * 18 + j);
        problem.bound.push_back(3e5 * std::sqrt(0.16 - r2));
      }
    }
    const std::size_t m = problem.size();
    problem.free_slip.assign(2 * m, slip_x);
    std::fill(problem.free_slip.begin() + static_cast<std::ptrdiff_t>(m), problem.free_slip.end(),
              slip_y);
    problem.stiffness = 1e10;
    problem.smallest_shear = 1e-6;
  }
};

double difference(const Field& a, const Field& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

}  // namespace

TEST_CASE("gmres solves non-symmetric systems to the requested residual") {
  constexpr int n = 14;
  Matrix matrix(n, n), near_inverse(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) matrix(i, j) = std::sin(7 * i + 3 * i * j + j) + (i == j ? 3 : 0);
  }
  near_inverse = (matrix + 0.1 * Matrix::Identity(n, n)).inverse();
  const Matrix one = Matrix::Identity(n, n);
  Field b(n), x;
  for (int i = 0; i < n; ++i) b[i] = std::cos(i);
  const Vector right = Eigen::Map<const Vector>(b.data(), n);
  const auto left = [&] {
    return (right - matrix * Eigen::Map<const Vector>(x.data(), n)).norm() / right.norm();
  };
  double before = 1.0;
  for (int max_vectors = 1; max_vectors <= n; ++max_vectors) {
    CHECK(contact::gmres(map_of(matrix), map_of(one), b, 1e-14, max_vectors, x) == max_vectors);
    CHECK(left() <= before * (1 + 1e-12));
    before = left();
  }
  CHECK(before < 1e-12);
  const Vector exact = matrix.partialPivLu().solve(right);
  for (int i = 0; i < n; ++i) CHECK(x[i] == doctest::Approx(exact[i]));
  // The residual is that of the system itself, for any preconditioner.
  for (const double gain : {1e-2, 1e-6, 1e-10}) {
    const int steps = contact::gmres(map_of(matrix), map_of(near_inverse), b, gain, n, x);
    CHECK(left() < gain);
    CHECK(steps <= 9);
  }
  // The iteration ends if one step suffices; zero yields zero.
  const Matrix twice = 2 * one;
  CHECK(contact::gmres(map_of(twice), map_of(one), b, 1e-14, n, x) == 1);
  for (int i = 0; i < n; ++i) CHECK(x[i] == doctest::Approx(b[i] / 2));
  CHECK(contact::gmres(map_of(matrix), map_of(one), Field(n, 0.0), 1e-14, n, x) == 0);
  CHECK(x == Field(n, 0.0));
}

TEST_CASE("projected gradients converge if Newton steps do not") {
  const Setup right(8e-6, 3e-6);
  Setup wrong(8e-6, 3e-6);
  wrong.operators.near = operators::NearTangential(wrong.grid, {much_stiffer, much_stiffer});
  contact::ShearApplier applier(right.problem), misled(wrong.problem);
  const auto expected = contact::solve_partial_slip(right.problem, applier, {}, 1e-9, 60);
  CHECK(expected.converged);
  CHECK(expected.fallbacks == 0);
  const auto found = contact::solve_partial_slip(wrong.problem, misled, {}, 1e-6, 100);
  CHECK(found.converged);
  CHECK(found.fallbacks > 0);
  CHECK(difference(found.shear, expected.shear) < 1e-5 * 3e5);
  CHECK(std::count(found.slipping.begin(), found.slipping.end(), 1) ==
        std::count(expected.slipping.begin(), expected.slipping.end(), 1));
}

TEST_CASE("incremental rolling reaches the steady state without Newton steps") {
  Setup right(4e-7, 1e-7), wrong(4e-7, 1e-7);
  for (Setup* setup : {&right, &wrong}) setup->problem.carried = 18;
  wrong.operators.near = operators::NearTangential(wrong.grid, {much_stiffer, much_stiffer});
  contact::ShearApplier applier(right.problem), misled(wrong.problem);
  const auto expected = contact::solve_steady_rolling(right.problem, applier, {}, 1e-9, 60);
  CHECK(expected.converged);
  CHECK(expected.fallbacks == 0);
  const auto slipping = std::count(expected.slipping.begin(), expected.slipping.end(), 1);
  CHECK(slipping > 10);
  CHECK(slipping < static_cast<std::ptrdiff_t>(right.problem.size()) - 10);
  const auto found = contact::solve_steady_rolling(wrong.problem, misled, {}, 1e-2, 60);
  CHECK(found.converged);
  CHECK(found.fallbacks > 0);
  CHECK(difference(found.shear, expected.shear) < 1e-2 * 3e5);
}
