// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of a rectangle from its Fourier modes, by rings in wavenumber: each ring
// is a window half as wide as the previous one. The Fourier sum of each ring is short and has a
// period of its own, so that nothing wraps around and offsets are exact (docs/theory/layers.md).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::kernels {

/// Distances along x and y that the body has travelled below the source [m], and its speed over the
/// smallest diffusivity [1/m].
struct WakeLengths {
  double x = 0.0, y = 0.0, speed = 0.0;
};

/// Components of Fourier modes exp(i (kx x + ky y)), the real factors of kernels/wave.hpp.
struct RingWaves {
  std::vector<Parity> parities;
  /// At kx, ky >= 0, for all components; finite at kx = ky = 0 unless is_singular.
  std::function<void(double kx, double ky, double* values)> at;
  double highest;            // wavenumber beyond which they are negligible [1/m]
  double longest;            // length over which they vary in space beyond the offsets [m]
  bool is_singular = false;  // they grow like 1/q as q -> 0, and are not evaluated at 0
  WakeLengths wake{};        // of a source that moves
  /// Periods of the surface [m], 0: not periodic. The mean of both is not included if is_singular.
  double period_x = 0.0, period_y = 0.0;
  /// Index of each component after kx and ky are exchanged; empty: the modes have no such symmetry.
  std::vector<std::size_t> exchanged{};
};

/// Influence of a rectangle dx by dy with a unit load at offsets >= 0 [m] from its centre:
/// [component][j][i], to 1e-9 of the largest value.
Field ring_sums(const RingWaves& waves, double dx, double dy, std::span<const double> x,
                std::span<const double> y);

/// Influence of an infinite strip along y, from the modes along x: [component][i].
Field ring_strip_sums(const RingWaves& waves, double dx, std::span<const double> x);

}  // namespace samcontact::kernels
