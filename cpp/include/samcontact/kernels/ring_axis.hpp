// SPDX-License-Identifier: GPL-3.0-or-later
// Windows in wavenumber and their Fourier sums along one axis, for sums over rings.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace samcontact::kernels::ring {

using Matrix = Eigen::MatrixXd;

/// Width of the edges of windows, and distance at which their kernels have decayed:
/// exp(-(reach/2)^2).
inline constexpr double edge = 0.2, reach = 9.0;
/// Wavenumber of the last disc times the longest length: its sum covers distances up to 90 times
/// that length.
inline constexpr double last = 0.2;
inline constexpr double negligible = 1e-13;
/// 1 below q1, 0 above.
inline double window(double q, double q1) { return 0.5 * std::erfc((q / q1 - 1) / edge); }

/// Decay lengths of a wake after which it is negligible.
inline constexpr double wake_lengths = 20.0;
/// Distance from the real axis at which the modes of wavenumber k across a motion have a
/// singularity along it. speed: over the diffusivity.
inline double wake_scale(double speed, double k) {
  return 2 * k * k / (speed + std::hypot(speed, 2 * k));
}

inline double sinc(double x) { return x == 0 ? 1.0 : std::sin(x) / x; }

/// Wavenumbers of a ring along one axis, and their modes at the offsets within its range.
struct Axis {
  std::vector<int> places;  // of offsets
  Eigen::VectorXd k;
  Matrix even, odd;  // [offset][wavenumber], with the weight of the sum

  /// repeat: period of the surface; 0: not periodic.
  Axis(std::span<const double> offsets, double cell, double support, double wavenumber,
       bool is_last, double repeat = 0.0) {
    const double reached = support + 0.5 * cell;
    // The wavenumbers of the surface, unless the kernel is so short that there is one image at
    // most.
    const bool overlaps = repeat > 0 && 2 * reached > repeat;
    std::vector<double> at;
    double farthest = 0.0;
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      double x = offsets[n];
      if (repeat > 0 && !overlaps) x -= repeat * std::round(x / repeat);
      if (!is_last && !overlaps && std::fabs(x) > reached) continue;
      places.push_back(static_cast<int>(n));
      at.push_back(x);
      farthest = std::max(farthest, std::fabs(x));
    }
    const double period = overlaps ? repeat : reached + (is_last ? reached : farthest);
    const int count =
        static_cast<int>(std::ceil((1 + 5 * edge) * wavenumber * period / (2 * std::numbers::pi))) +
        1;
    k = Eigen::VectorXd::LinSpaced(count, 0.0, 2 * std::numbers::pi / period * (count - 1));
    if (count == 1) k[0] = 0.0;
    const auto rows = static_cast<Eigen::Index>(places.size());
    even.resize(rows, count);
    odd.resize(rows, count);
    for (Eigen::Index m = 0; m < count; ++m) {
      const double weight = (m > 0 ? 2.0 : 1.0) * cell / period * sinc(0.5 * k[m] * cell);
      fill(m, weight, at);
    }
  }

 private:
  /// Offsets after which a phase is computed from scratch: the others follow from the last one by
  /// the theorem of addition if they are equidistant.
  static constexpr std::size_t fresh = 16;

  void fill(Eigen::Index m, double weight, const std::vector<double>& at) {
    double step = 0.0;
    std::complex<double> wave, turn = 1.0;
    for (std::size_t n = 0; n < at.size(); ++n) {
      const double next = n > 0 ? at[n] - at[n - 1] : 0.0;
      const bool same = std::fabs(next - step) <= 1e-15 * std::fabs(at[n]);
      if (n % fresh == 0 || !same) {
        wave = weight * std::polar(1.0, k[m] * at[n]);
      } else {
        wave = {wave.real() * turn.real() - wave.imag() * turn.imag(),
                wave.real() * turn.imag() + wave.imag() * turn.real()};
      }
      if (!same) turn = std::polar(1.0, k[m] * (step = next));
      even(static_cast<Eigen::Index>(n), m) = wave.real();
      odd(static_cast<Eigen::Index>(n), m) = wave.imag();
    }
  }
};

/// Factor of a window between two wavenumbers; inner = 0: without a lower edge.
inline double share(double q, double inner, double outer) {
  return window(q, outer) - (inner > 0 ? window(q, inner) : 0.0);
}

}  // namespace samcontact::kernels::ring
