// SPDX-License-Identifier: GPL-3.0-or-later
// Elimination of matrices that couple near cells of a grid, compared with products of dense
// matrices.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>
#include <random>

#include "samcontact/film/block_lu.hpp"

namespace samcontact::film {
namespace {

struct Side {
  int nx, ny, reach;
  bool wraps;
};

/// Uniform numbers from -1 to 1, the same in every run.
struct Random {
  std::mt19937 engine{3};  // NOLINT(bugprone-random-generator-seed)
  std::uniform_real_distribution<float> uniform{-1.0F, 1.0F};
  float operator()() { return uniform(engine); }
};

Lattice lattice_of(const Side& side) {
  return Lattice(Grid(side.nx, side.ny, 1e-5, 1e-5).made_periodic(false, side.wraps));
}

/// Random couplings of all near cells, without some of the diagonal, or with rows and columns of
/// very different sizes. The rest of the diagonal is as large as its row together.
NearMatrix random_matrix(const Lattice& lattice, int reach, bool needs_pivots, Random& random) {
  NearMatrix matrix(lattice, reach);
  const auto size = [&] { return needs_pivots ? 1.0F : std::pow(10.0F, 3 * random()); };
  Singles column(lattice.size());
  for (float& value : column) value = size();
  for (std::size_t cell = 0; cell < lattice.size(); ++cell) {
    const int i = static_cast<int>(cell) / lattice.ny(), j = static_cast<int>(cell) % lattice.ny();
    const float row = size();
    const float diagonal = needs_pivots && cell % 7 == 0 ? 0.0F : 0.5F * matrix.width();
    for (int a = -reach; a <= reach; ++a) {
      for (int b = -matrix.reach_y(); b <= matrix.reach_y(); ++b) {
        const std::ptrdiff_t at = lattice.at(i + a, j + b);
        if (at < 0) continue;
        const float coefficient = a == 0 && b == 0 ? diagonal : random();
        matrix.row(cell)[matrix.slot(a, b)] = coefficient * row * column[at];
      }
    }
  }
  return matrix;
}

Eigen::MatrixXd dense(const NearMatrix& matrix) {
  const Lattice& lattice = matrix.lattice();
  const auto n = static_cast<Eigen::Index>(lattice.size());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index cell = 0; cell < n; ++cell) {
    const int i = static_cast<int>(cell) / lattice.ny(), j = static_cast<int>(cell) % lattice.ny();
    for (int a = -matrix.reach(); a <= matrix.reach(); ++a) {
      for (int b = -matrix.reach_y(); b <= matrix.reach_y(); ++b) {
        const std::ptrdiff_t at = lattice.at(i + a, j + b);
        if (at >= 0) full(cell, at) += matrix.row(cell)[matrix.slot(a, b)];
      }
    }
  }
  return full;
}

}  // namespace

TEST_CASE("blocks are eliminated as in a dense matrix") {
  Random random;
  for (const Side& side : {Side{23, 31, 2, false}, Side{30, 18, 2, true}, Side{9, 4, 2, true},
                           Side{19, 22, 3, true}, Side{400, 1, 4, false}, Side{4, 4, 2, false}}) {
    const Lattice lattice = lattice_of(side);
    BlockLu factors(lattice, side.reach);
    for (const bool needs_pivots : {false, true}) {
      const NearMatrix matrix = random_matrix(lattice, side.reach, needs_pivots, random);
      const Eigen::MatrixXd full = dense(matrix);
      Eigen::VectorXd right(full.rows());
      for (double& value : right) value = random();
      REQUIRE(factors.decompose(matrix, std::vector<char>(lattice.size(), needs_pivots ? 1 : 0)));
      Singles x(right.begin(), right.end());
      factors.solve(x);
      CAPTURE(side.nx);
      CAPTURE(side.ny);
      CAPTURE(needs_pivots);
      // Rounding of single precision, relative to the terms of each row.
      const Eigen::VectorXd found =
          Eigen::Map<Eigen::VectorXf>(x.data(), full.rows()).cast<double>();
      const Eigen::VectorXd size = full.cwiseAbs() * found.cwiseAbs();
      const double error = ((full * found - right).array() / size.array()).abs().maxCoeff();
      CHECK(error < (needs_pivots ? 1e-3 : 1e-5));
    }
  }
}

TEST_CASE("a matrix with a row of zeros has no factors") {
  const Lattice lattice(Grid(12, 12, 1e-5, 1e-5));
  Random random;
  NearMatrix matrix = random_matrix(lattice, 2, false, random);
  std::fill_n(matrix.row(70), matrix.width(), 0.0F);
  BlockLu factors(lattice, 2);
  CHECK_FALSE(factors.decompose(matrix, std::vector<char>(lattice.size(), 0)));
}

TEST_CASE("the order of elimination has each cell once, and the dividing strip at the end") {
  for (const bool wraps : {false, true}) {
    const Lattice lattice = lattice_of({37, 50, 2, wraps});
    std::vector<int> places = dissect(lattice, 2).places;
    // The strip in the middle of the longer side comes last, but for the ends of the period.
    const int last = static_cast<int>(lattice.size()) - (wraps ? 2 * lattice.nx() : 0) - 1;
    const int end_y = (lattice.ny() + (wraps ? 2 : 0)) / 2;
    int latest = 0;
    for (int i = 0; i < lattice.nx(); ++i) latest = std::max(latest, places[lattice.at(i, end_y)]);
    CHECK(latest == last);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i) CHECK(places[i] == static_cast<int>(i));
  }
}

}  // namespace samcontact::film
