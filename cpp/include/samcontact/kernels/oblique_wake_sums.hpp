// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of a rectangle from its Fourier modes in a body that moves in a direction
// between x and y: modes vary rapidly where kx Vx = ky Vy, because heat diffuses slowly out of the
// wake (docs/theory/heat.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::kernels {

/// Components of Fourier modes exp(i (kx x + ky y)), the real factors of kernels/wave.hpp.
struct ObliqueWaves {
  std::vector<Parity> parities;
  /// At kx, ky > 0, for all components; at most of order 1/q as q -> 0.
  std::function<void(double kx, double ky, double* values)> at;
  double highest;           // wavenumber beyond which they are negligible [1/m]
  double longest;           // length over which they vary in space beyond the offsets [m]
  double speed_x, speed_y;  // of the body over the smallest diffusivity, not 0 [1/m]
};

/// Influence of a rectangle dx by dy with a unit load at offsets >= 0 [m] from its centre:
/// [component][j][i].
Field oblique_wake_sums(const ObliqueWaves& waves, double dx, double dy, std::span<const double> x,
                        std::span<const double> y);

}  // namespace samcontact::kernels
