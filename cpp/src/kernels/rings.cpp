// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/rings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::kernels {
namespace {

using Matrix = Eigen::MatrixXd;

using std::numbers::pi;
/// Width of the edges of windows, and distance at which their kernels have decayed:
/// exp(-(reach/2)^2).
constexpr double edge = 0.2, reach = 9.0;
/// Wavenumber of the last disc times the longest length: its sum covers distances up to 90 times
/// that length.
constexpr double last = 0.2;
constexpr double negligible = 1e-13;
/// Smallest wavenumber of a strip, times the longest length: the limit at 0 depends on the
/// direction.
constexpr double shortest = 1e-5;

/// 1 below q1, 0 above.
double window(double q, double q1) { return 0.5 * std::erfc((q / q1 - 1) / edge); }

double sinc(double x) { return x == 0 ? 1.0 : std::sin(x) / x; }

/// Wavenumbers of a ring along one axis, and their modes at the offsets within its range.
struct RingAxis {
  std::vector<int> places;  // of offsets
  Eigen::VectorXd k;
  Matrix even, odd;  // [offset][wavenumber], with the weight of the sum

  RingAxis(std::span<const double> offsets, double cell, double support, double wavenumber,
           bool is_last) {
    const double reached = support + 0.5 * cell;
    double farthest = 0.0;
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      if (!is_last && offsets[n] > reached) continue;
      places.push_back(static_cast<int>(n));
      farthest = std::max(farthest, offsets[n]);
    }
    const double period = reached + (is_last ? reached : farthest);
    const int count =
        static_cast<int>(std::ceil((1 + 5 * edge) * wavenumber * period / (2 * pi))) + 1;
    k = Eigen::VectorXd::LinSpaced(count, 0.0, 2 * pi / period * (count - 1));
    if (count == 1) k[0] = 0.0;
    const auto rows = static_cast<Eigen::Index>(places.size());
    even.resize(rows, count);
    odd.resize(rows, count);
    for (Eigen::Index m = 0; m < count; ++m) {
      const double weight = (m > 0 ? 2.0 : 1.0) * cell / period * sinc(0.5 * k[m] * cell);
      for (Eigen::Index n = 0; n < rows; ++n) {
        const double phase = k[m] * offsets[places[n]];
        even(n, m) = weight * std::cos(phase);
        odd(n, m) = weight * std::sin(phase);
      }
    }
  }
};

/// Adds one ring between wavenumbers inner and outer to the sums.
void add_ring(const RingWaves& waves, const RingAxis& x, const RingAxis& y, double inner,
              double outer, std::size_t nx, std::size_t plane, Field& sums) {
  const std::size_t count = waves.parities.size();
  std::vector<Matrix> values(count, Matrix::Zero(x.k.size(), y.k.size()));
  std::vector<double> wave(count);
  for (Eigen::Index n = 0; n < y.k.size(); ++n) {
    for (Eigen::Index m = 0; m < x.k.size(); ++m) {
      const double q = std::hypot(x.k[m], y.k[n]);
      const double share = window(q, outer) - (inner > 0 ? window(q, inner) : 0.0);
      if (std::fabs(share) < negligible) continue;
      waves.at(x.k[m], y.k[n], wave.data());
      for (std::size_t c = 0; c < count; ++c) values[c](m, n) = share * wave[c];
    }
  }
  for (std::size_t c = 0; c < count; ++c) {
    const auto& [odd_x, odd_y, odd_z] = waves.parities[c];
    const Matrix ring = (odd_x ? x.odd : x.even) * values[c] * (odd_y ? y.odd : y.even).transpose();
    for (std::size_t n = 0; n < y.places.size(); ++n) {
      double* row = sums.data() + c * plane + y.places[n] * nx;
      for (std::size_t m = 0; m < x.places.size(); ++m) row[x.places[m]] += ring(m, n);
    }
  }
}

/// Calls add(inner, outer, support, is_last) for each ring whose kernel extends beyond a cell.
template <class Add>
void for_each_ring(const RingWaves& waves, double extent, double smallest_cell, const Add& add) {
  for (double outer = waves.highest;; outer *= 0.5) {
    const bool is_last = outer * extent < last;
    const double inner = is_last ? 0.0 : 0.5 * outer;
    const double support = reach / (edge * (is_last ? outer : inner));
    // A kernel shorter than a cell acts through its integral only, which is zero for a ring.
    if (is_last || support >= 0.5 * smallest_cell) add(inner, outer, support, is_last);
    if (is_last) return;
  }
}

}  // namespace

Field ring_sums(const RingWaves& waves, double dx, double dy, std::span<const double> x,
                std::span<const double> y) {
  Field sums(waves.parities.size() * x.size() * y.size(), 0.0);
  const double extent = std::max({std::ranges::max(x), std::ranges::max(y), waves.longest});
  for_each_ring(waves, extent, std::min(dx, dy),
                [&](double inner, double outer, double support, bool is_last) {
                  add_ring(waves, {x, dx, support, outer, is_last},
                           {y, dy, support, outer, is_last}, inner, outer, x.size(),
                           x.size() * y.size(), sums);
                });
  return sums;
}

Field ring_strip_sums(const RingWaves& waves, double dx, std::span<const double> x) {
  const std::size_t count = waves.parities.size();
  Field sums(count * x.size(), 0.0);
  std::vector<double> wave(count);
  const double extent = std::max(std::ranges::max(x), waves.longest);
  for_each_ring(waves, extent, dx, [&](double inner, double outer, double support, bool is_last) {
    const RingAxis axis(x, dx, support, outer, is_last);
    Matrix values = Matrix::Zero(axis.k.size(), static_cast<Eigen::Index>(count));
    for (Eigen::Index m = 0; m < axis.k.size(); ++m) {
      const double q = axis.k[m];
      const double share = window(q, outer) - (inner > 0 ? window(q, inner) : 0.0);
      if (std::fabs(share) < negligible) continue;
      waves.at(std::max(q, shortest / waves.longest), 0.0, wave.data());
      for (std::size_t c = 0; c < count; ++c) values(m, c) = share * wave[c];
    }
    for (std::size_t c = 0; c < count; ++c) {
      if (waves.parities[c].odd_y) continue;
      const auto& side = waves.parities[c].odd_x ? axis.odd : axis.even;
      const Eigen::VectorXd ring = side * values.col(static_cast<Eigen::Index>(c));
      for (std::size_t n = 0; n < axis.places.size(); ++n) {
        sums[c * x.size() + axis.places[n]] += ring[static_cast<Eigen::Index>(n)];
      }
    }
  });
  return sums;
}

}  // namespace samcontact::kernels
