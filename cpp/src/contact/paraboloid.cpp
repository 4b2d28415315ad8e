// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/paraboloid.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/base/magnitude.hpp"

namespace samcontact::contact {

namespace {

constexpr int points_per_side = 17;
constexpr double min_curvature_ratio = 1e-9;

using Terms = Eigen::Vector<double, 6>;

/// Terms of a paraboloid at a point, whose coordinates are divided by the half-lengths of the grid.
Terms terms_at(double x, double y) { return {1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y}; }

struct FittedPoint {
  Terms terms;
  double height;
};

std::vector<FittedPoint> points_of(std::span<const double> heights, const Grid& grid) {
  const int rows = std::min(grid.nx, points_per_side), columns = std::min(grid.ny, points_per_side);
  std::vector<FittedPoint> points;
  points.reserve(static_cast<std::size_t>(rows) * columns);
  for (int r = 0; r < rows; ++r) {
    const int i = static_cast<int>(static_cast<std::ptrdiff_t>(r) * (grid.nx - 1) / (rows - 1));
    const double x = (2.0 * i - (grid.nx - 1)) / (grid.nx - 1);
    for (int c = 0; c < columns; ++c) {
      const int j =
          static_cast<int>(static_cast<std::ptrdiff_t>(c) * (grid.ny - 1) / (columns - 1));
      const double y = (2.0 * j - (grid.ny - 1)) / (grid.ny - 1);
      points.push_back({terms_at(x, y), heights[static_cast<std::size_t>(i) * grid.ny + j]});
    }
  }
  return points;
}

/// Factors of the terms by least squares; the matrix of the normal equations is positive definite.
Terms factors_of(std::span<const FittedPoint> points) {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right = Terms::Zero();
  for (const auto& [terms, height] : points) {
    matrix += terms * terms.transpose();
    right += terms * height;
  }
  return matrix.llt().solve(right);
}

}  // namespace

std::optional<Paraboloid> fitted_paraboloid(std::span<const double> heights, const Grid& grid,
                                            const ParaboloidTolerance& tolerance) {
  assert(heights.size() == grid.surface_size());
  if (std::min(grid.nx, grid.ny) < 3 || !magnitude_of(heights).is_finite) return {};
  auto points = points_of(heights, grid);
  const auto [low, high] = std::ranges::minmax(points, {}, &FittedPoint::height);
  const double lowest = low.height, range = high.height - lowest;
  if (!(range > 0 && range <= std::numeric_limits<double>::max())) return {};
  for (auto& point : points) point.height = (point.height - lowest) / range;
  const Terms factors = factors_of(points);
  double deviation = 0.0;
  for (const auto& [terms, height] : points) {
    deviation = std::max(deviation, std::fabs(factors.dot(terms) - height));
  }
  if (!(deviation <= tolerance.on_grid)) return {};
  const double a = 0.5 * (grid.nx - 1) * grid.dx, b = 0.5 * (grid.ny - 1) * grid.dy;
  const double xx = factors[3] / (a * a), xy = factors[4] / (a * b), yy = factors[5] / (b * b);
  const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  if (!(mean - half > min_curvature_ratio * (mean + half))) return {};
  const double allowed = 0.5 * tolerance.at_reach / std::max(deviation, 1e-30);
  const auto reach = [&](double side, double part) {
    return side * std::sqrt(std::max(allowed * part, 1.0));
  };
  // the plane of the larger radius is perpendicular to that of the largest curvature
  const double cosine = std::sin(0.5 * std::atan2(2.0 * xy, xx - yy));
  return Paraboloid{1.0 / (range * (mean - half)),
                    1.0 / (range * (mean + half)),
                    cosine,
                    {reach(a, factors[3]), reach(b, factors[5])}};
}

}  // namespace samcontact::contact
