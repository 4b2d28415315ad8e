// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/rings.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/kernels/ring_axis.hpp"
#include "samcontact/kernels/ring_product.hpp"

namespace samcontact::kernels {
namespace {

using ring::Matrix;

/// Smallest wavenumber of a strip, times the longest length: the limit at 0 depends on the
/// direction.
constexpr double shortest = 1e-5;
/// Wavenumber below which modes that grow like 1/q are left out, times the longest length.
constexpr double smallest_singular = 1e-10;

/// Adds one ring between wavenumbers inner and outer to the sums. If both axes are the same object,
/// half of the modes and sums follow from the symmetry of the others.
void add_ring(const RingWaves& waves, const ring::Axis& x, const ring::Axis& y, double inner,
              double outer, std::size_t nx, std::size_t plane, Field& sums) {
  const std::size_t count = waves.parities.size();
  std::vector<Matrix> values(count, Matrix::Zero(x.k.size(), y.k.size()));
  std::vector<double> wave(count);
  const bool symmetric = &x == &y && !waves.exchanged.empty();
  for (Eigen::Index n = 0; n < y.k.size(); ++n) {
    for (Eigen::Index m = symmetric ? n : 0; m < x.k.size(); ++m) {
      const double q = std::hypot(x.k[m], y.k[n]);
      const double share = ring::share(q, inner, outer);
      if (std::fabs(share) < ring::negligible) continue;
      waves.at(x.k[m], y.k[n], wave.data());
      for (std::size_t c = 0; c < count; ++c) values[c](m, n) = share * wave[c];
      if (!symmetric || m == n) continue;
      for (std::size_t c = 0; c < count; ++c) values[waves.exchanged[c]](n, m) = share * wave[c];
    }
  }
  Matrix ring(x.even.rows(), y.even.rows());
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t other = symmetric ? waves.exchanged[c] : c;
    if (other < c) continue;  // known
    const auto& [odd_x, odd_y, odd_z] = waves.parities[c];
    const Matrix &left = odd_x ? x.odd : x.even, &right = odd_y ? y.odd : y.even;
    ring_product({left.data(), values[c].data(), right.data(), static_cast<int>(left.rows()),
                  static_cast<int>(left.cols()), static_cast<int>(right.cols()),
                  static_cast<int>(right.rows())},
                 ring.data());
    for (std::size_t n = 0; n < y.places.size(); ++n) {
      double* row = sums.data() + c * plane + y.places[n] * nx;
      for (std::size_t m = 0; m < x.places.size(); ++m) row[x.places[m]] += ring(m, n);
      if (other == c) continue;
      row = sums.data() + other * plane + y.places[n] * nx;
      for (std::size_t m = 0; m < x.places.size(); ++m) row[x.places[m]] += ring(n, m);
    }
  }
}

/// Part of the travel of a source within which the kernel of a ring extends downstream.
double wake_part(const WakeLengths& wake, double outer) {
  const double travel = std::hypot(wake.x, wake.y);
  if (travel == 0) return 0.0;
  const double length = ring::wake_lengths / ring::wake_scale(wake.speed, ring::edge * outer);
  return std::min(1.0, length / travel);
}

/// Calls add(inner, outer, support, is_last) for each ring whose kernel extends beyond a cell.
template <class Add>
void for_each_ring(const RingWaves& waves, double extent, double smallest_cell, const Add& add) {
  for (double outer = waves.highest;; outer *= 0.5) {
    // Modes that grow like 1/q have no last disc: their share below the last ring is negligible.
    if (waves.is_singular && outer * extent < smallest_singular) return;
    const bool is_last = !waves.is_singular && outer * extent < ring::last;
    const double inner = is_last ? 0.0 : 0.5 * outer;
    const double support = ring::reach / (ring::edge * (is_last ? outer : inner));
    // A kernel shorter than a cell acts through its integral only, which is zero for a ring.
    const double wake = wake_part(waves.wake, outer) * std::max(waves.wake.x, waves.wake.y);
    if (is_last || support + wake >= 0.5 * smallest_cell) add(inner, outer, support, is_last);
    if (is_last) return;
  }
}

}  // namespace

Field ring_sums(const RingWaves& waves, double dx, double dy, std::span<const double> x,
                std::span<const double> y) {
  Field sums(waves.parities.size() * x.size() * y.size(), 0.0);
  const double extent = std::max({std::ranges::max(x), std::ranges::max(y), waves.longest});
  const bool equal = dx == dy && waves.wake.x == waves.wake.y && waves.period_x == waves.period_y &&
                     std::ranges::equal(x, y);
  for_each_ring(
      waves, extent, std::min(dx, dy),
      [&](double inner, double outer, double support, bool is_last) {
        const double part = wake_part(waves.wake, outer);
        const ring::Axis along_x(x, dx, support + part * waves.wake.x, outer, is_last,
                                 waves.period_x);
        const auto add = [&](const ring::Axis& along_y) {
          add_ring(waves, along_x, along_y, inner, outer, x.size(), x.size() * y.size(), sums);
        };
        if (equal) return add(along_x);
        add(ring::Axis(y, dy, support + part * waves.wake.y, outer, is_last, waves.period_y));
      });
  return sums;
}

Field ring_strip_sums(const RingWaves& waves, double dx, std::span<const double> x) {
  const std::size_t count = waves.parities.size();
  Field sums(count * x.size(), 0.0);
  std::vector<double> wave(count);
  const double extent = std::max(std::ranges::max(x), waves.longest);
  for_each_ring(waves, extent, dx, [&](double inner, double outer, double support, bool is_last) {
    const ring::Axis axis(x, dx, support, outer, is_last);
    Matrix values = Matrix::Zero(axis.k.size(), static_cast<Eigen::Index>(count));
    for (Eigen::Index m = 0; m < axis.k.size(); ++m) {
      const double q = axis.k[m];
      const double share = ring::share(q, inner, outer);
      if (std::fabs(share) < ring::negligible) continue;
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
