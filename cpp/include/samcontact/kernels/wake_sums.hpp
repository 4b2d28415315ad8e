// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of a rectangle from its Fourier modes in a body that moves along x: modes
// vary rapidly where kx is small, because heat diffuses slowly out of the wake
// (docs/theory/heat.md).
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::kernels {

/// Components of Fourier modes exp(i (kx x + ky y)): the factors Q of the spectrum (-i)^n Q of a
/// field that is odd in n of x and y at rest; Q(-kx, ky) is the complex conjugate.
struct WakeWaves {
  std::vector<Parity> parities;  // at rest
  /// At kx, ky > 0, for all components; at most of order 1/q as q -> 0. Copies must be independent.
  std::function<void(double kx, double ky, std::complex<double>* values)> at;
  double highest;  // wavenumber beyond which they are negligible [1/m]
  double longest;  // length over which they vary in space beyond the offsets [m]
  double speed;    // of the body over the smallest diffusivity, >= 0 [1/m]
};

/// Influence of a rectangle dx by dy with a unit load at offsets >= 0 [m] from its centre:
/// [component][part][j][i], part 0 with the parity at rest, part 1 opposite in x.
Field wake_sums(const WakeWaves& waves, double dx, double dy, std::span<const double> x,
                std::span<const double> y);

}  // namespace samcontact::kernels
