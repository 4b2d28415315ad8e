// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest balls against the best of all balls through a few of the points.
#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "samcontact/fatigue/smallest_ball.hpp"

using samcontact::fatigue::SmallestBall;

namespace {

using Points = std::vector<Eigen::VectorXd>;

template <int D>
SmallestBall<D> ball_of(const Points& points) {
  const std::size_t n = points.size();
  std::vector<double> rows(D * n), work(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (int d = 0; d < D; ++d) rows[d * n + i] = points[i][d];
  }
  return SmallestBall<D>(rows.data(), n, work.data());
}

/// Smallest of all circumscribed balls of subsets that contains every point.
double radius_of_subsets(const Points& points) {
  const int n = static_cast<int>(points.size()), dimension = static_cast<int>(points[0].size());
  double best = std::numeric_limits<double>::infinity();
  for (unsigned set = 1; set < (1U << n); ++set) {
    std::vector<int> members;
    for (int i = 0; i < n; ++i) {
      if ((set >> i & 1U) != 0) members.push_back(i);
    }
    const int m = static_cast<int>(members.size());
    if (m > dimension + 1) continue;
    // The circumscribed centre in the flat of the members, by orthogonal directions within it; a
    // repeated member or one in the flat of the others adds none.
    Eigen::VectorXd centre = points[members[0]];
    Points directions;
    for (int k = 1; k < m; ++k) {
      const Eigen::VectorXd edge = points[members[k]] - points[members[0]];
      Eigen::VectorXd direction = edge;
      for (int repeat = 0; repeat < 2; ++repeat) {
        for (const auto& other : directions) direction -= other.dot(direction) * other;
      }
      if (direction.norm() <= 1e-9 * edge.norm()) continue;
      direction.normalize();
      const double missing = edge.squaredNorm() / 2 - edge.dot(centre - points[members[0]]);
      centre += missing / edge.dot(direction) * direction;
      directions.push_back(direction);
    }
    double radius = 0.0;
    for (const auto& point : points) radius = std::max(radius, (point - centre).norm());
    best = std::min(best, radius);
  }
  return best;
}

enum class Kind { scattered, repeated, on_line, on_plane, on_sphere, on_circle, on_lattice, near };

/// Nine points, far from the origin.
Points points_of(Kind kind, int dimension, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    Eigen::VectorXd v(dimension);
    for (double& x : v) x = normal(random);
    return v;
  };
  const Eigen::VectorXd first = vector().normalized(), other = vector(), middle = 10 * vector();
  const Eigen::VectorXd second = (other - other.dot(first) * first).normalized();
  Points points;
  for (int i = 0; i < 9; ++i) {
    const double a = normal(random), b = normal(random), angle = 2 * std::numbers::pi * i / 8;
    Eigen::VectorXd v = vector();
    switch (kind) {
      case Kind::scattered:
        break;
      case Kind::repeated:
        v = i % 3 == 0 || i < 3 ? v : Eigen::VectorXd(points[i % 3] - middle);
        break;
      case Kind::on_line:
        v = a * first;
        break;
      case Kind::on_plane:
        v = a * first + b * second;
        break;
      case Kind::on_sphere:
        v.normalize();
        break;
      case Kind::on_circle:
        v = std::cos(angle) * first + std::sin(angle) * second;
        break;
      case Kind::on_lattice:
        v = v.array().round();
        break;
      case Kind::near:
        v = first + 1e-7 * v;
        break;
    }
    points.emplace_back(middle + v);
  }
  return points;
}

template <int D>
void compare_with_subsets() {
  std::mt19937 random(7);  // NOLINT(bugprone-random-generator-seed): the same in every run
  for (const Kind kind : {Kind::scattered, Kind::repeated, Kind::on_line, Kind::on_plane,
                          Kind::on_sphere, Kind::on_circle, Kind::on_lattice, Kind::near}) {
    for (int round = 0; round < 10; ++round) {
      const Points points = points_of(kind, D, random);
      const auto ball = ball_of<D>(points);
      CAPTURE(static_cast<int>(kind));
      // The position of close points is limited by the rounding of their distance from the origin.
      const double rounding = kind == Kind::near ? 1e-6 : 1e-12;
      CHECK(ball.radius() == doctest::Approx(radius_of_subsets(points)).epsilon(rounding));
      const Eigen::Map<const Eigen::VectorXd> centre(ball.centre().data(), D);
      for (const auto& point : points)
        CHECK((point - centre).norm() <= ball.radius() * (1 + 1e-14));
      // a mean of points on the boundary: no ball is smaller
      for (int d = 0; d < D; ++d) {
        double mean = 0.0;
        for (std::size_t m = 0; m < ball.held(); ++m) {
          CHECK(ball.weight(m) >= 0);
          mean += ball.weight(m) * points[ball.holder(m)][d];
        }
        CHECK(mean == doctest::Approx(ball.centre()[d]).epsilon(1e-12));
      }
    }
  }
}

}  // namespace

TEST_CASE("the smallest circle is that of the best subset") { compare_with_subsets<2>(); }

TEST_CASE("the smallest ball in five dimensions is that of the best subset") {
  compare_with_subsets<5>();
}

TEST_CASE("the ball of one point has zero radius") {
  const auto ball = ball_of<5>({Eigen::VectorXd::Constant(5, 3.0)});
  CHECK(ball.radius() == 0.0);
  CHECK(ball.centre()[4] == 3.0);
}
