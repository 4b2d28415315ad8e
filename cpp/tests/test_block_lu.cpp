// SPDX-License-Identifier: GPL-3.0-or-later
// Elimination of matrices that couple near cells of a grid, compared with Eigen's dense matrices.
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

/// Random couplings of all near cells, in rows and columns of very different sizes; the diagonal is
/// as large as the others of its row together.
NearMatrix random_matrix(const Lattice& lattice, int reach, Random& random) {
  NearMatrix matrix(lattice, reach);
  std::vector<float> column(lattice.size());
  for (float& size : column) size = std::pow(10.0F, 3 * random());
  for (std::size_t cell = 0; cell < lattice.size(); ++cell) {
    const int i = static_cast<int>(cell) / lattice.ny(), j = static_cast<int>(cell) % lattice.ny();
    const float scale = std::pow(10.0F, 3 * random());
    for (int a = -reach; a <= reach; ++a) {
      for (int b = -matrix.reach_y(); b <= matrix.reach_y(); ++b) {
        const std::ptrdiff_t at = lattice.at(i + a, j + b);
        if (at < 0) continue;
        const float own = a == 0 && b == 0 ? 0.5F * static_cast<float>(matrix.width()) : random();
        matrix.row(cell)[matrix.slot(a, b)] = own * scale * column[at];
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
                           Side{19, 22, 3, true}, Side{400, 1, 4, false}, Side{1, 1, 2, false}}) {
    const Lattice lattice = lattice_of(side);
    BlockLu factors(lattice, side.reach);
    for (int repeated = 0; repeated < 2; ++repeated) {
      const NearMatrix matrix = random_matrix(lattice, side.reach, random);
      const Eigen::MatrixXd full = dense(matrix);
      Eigen::VectorXd right(full.rows());
      for (double& value : right) value = random();
      const Eigen::VectorXd expected = full.fullPivLu().solve(right);
      REQUIRE(factors.decompose(matrix));
      std::vector<float> x(right.begin(), right.end());
      factors.solve(x);
      CAPTURE(side.nx);
      CAPTURE(side.ny);
      // The rounding of single precision, in each unknown: their sizes differ by powers of ten.
      double error = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double size = (full.row(k).array().abs() * expected.transpose().array().abs()).sum();
        const double found =
            (full.row(k) * Eigen::Map<Eigen::VectorXf>(x.data(), full.rows()).cast<double>())
                .value();
        error = std::max(error, std::fabs(found - right[k]) / size);
      }
      CHECK(error < 1e-5);
    }
  }
}

TEST_CASE("a matrix with a row of zeros has no factors") {
  const Lattice lattice(Grid(12, 12, 1e-5, 1e-5));
  Random random;
  NearMatrix matrix = random_matrix(lattice, 2, random);
  std::fill_n(matrix.row(70), matrix.width(), 0.0F);
  BlockLu factors(lattice, 2);
  CHECK_FALSE(factors.decompose(matrix));
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
