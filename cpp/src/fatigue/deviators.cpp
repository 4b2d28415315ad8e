// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fatigue/deviators.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "samcontact/fatigue/smallest_ball.hpp"

namespace samcontact::fatigue {
namespace {

constexpr double root3 = std::numbers::sqrt3;
constexpr std::size_t work_rows = 7;  // five of the deviator, its squares, the mean stress

/// The deviator in coordinates whose square is its second invariant, and the mean stress.
void resolve(const double* path, std::size_t moments, double* deviator, double* mean) {
  const double *xx = path, *yy = path + moments, *zz = path + 2 * moments;
  for (std::size_t t = 0; t < moments; ++t) {
    deviator[t] = (xx[t] - yy[t]) / 2;
    deviator[moments + t] = ((zz[t] - xx[t]) + (zz[t] - yy[t])) / (2 * root3);
    mean[t] = (xx[t] + yy[t] + zz[t]) / 3;
  }
  std::copy(path + 3 * moments, path + 6 * moments, deviator + 2 * moments);
}

/// Half the difference of the largest and smallest principal value.
double tresca(const std::array<double, 5>& d) {
  const double zz = 2 * d[1] / root3, xx = d[0] - zz / 2, yy = -d[0] - zz / 2;
  Eigen::Matrix3d tensor;
  tensor << xx, d[4], d[3], d[4], yy, d[2], d[3], d[2], zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
  return (solver.eigenvalues()[2] - solver.eigenvalues()[0]) / 2;
}

/// Maximum of tau + slope * mean about a centre.
double largest(const double* deviator, const double* mean, std::size_t moments,
               const std::array<double, 5>& centre, double slope, double* bound) {
  const auto about = [&](std::size_t t) {
    std::array<double, 5> d;
    for (std::size_t c = 0; c < 5; ++c) d[c] = deviator[c * moments + t] - centre[c];
    return d;
  };
  std::fill_n(bound, moments, 0.0);
  for (std::size_t c = 0; c < 5; ++c) {
    for (std::size_t t = 0; t < moments; ++t) {
      const double d = deviator[c * moments + t] - centre[c];
      bound[t] += d * d;
    }
  }
  // The square root of the second invariant is an upper bound of tau.
  for (std::size_t t = 0; t < moments; ++t) bound[t] = std::sqrt(bound[t]) + slope * mean[t];
  const std::size_t likely = std::max_element(bound, bound + moments) - bound;
  double found = tresca(about(likely)) + slope * mean[likely];
  for (std::size_t t = 0; t < moments; ++t) {
    if (t != likely && bound[t] > found)
      found = std::max(found, tresca(about(t)) + slope * mean[t]);
  }
  return found;
}

}  // namespace

Field dang_van(const Paths& stress, double slope) {
  Field out(stress.cells);
  const std::size_t moments = row_length(stress.moments);
  for_each_path<1>({stress}, work_rows, [&](std::size_t cell, const auto& path, double* work) {
    double *squares = work + 5 * moments, *mean = work + 6 * moments;
    resolve(path[0], moments, work, mean);
    const SmallestBall<5> ball(work, moments, squares);
    out[cell] = largest(work, mean, moments, ball.centre(), slope, squares);
  });
  return out;
}

Field crossland(const Paths& stress, double slope) {
  Field out(stress.cells);
  const std::size_t moments = row_length(stress.moments);
  for_each_path<1>({stress}, work_rows, [&](std::size_t cell, const auto& path, double* work) {
    double *squares = work + 5 * moments, *mean = work + 6 * moments;
    resolve(path[0], moments, work, mean);
    const SmallestBall<5> ball(work, moments, squares);
    out[cell] = ball.radius() + slope * *std::max_element(mean, mean + moments);
  });
  return out;
}

}  // namespace samcontact::fatigue
