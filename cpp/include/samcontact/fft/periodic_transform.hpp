// SPDX-License-Identifier: GPL-3.0-or-later
// Convolution of a plane with an even kernel on a periodic grid that may be larger than the plane,
// for operators that do not need full padding.
#pragma once

#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/padded_transform.hpp"

namespace samcontact::fft {

/// Planes of nx x ny [i][j] at the corner of a periodic grid of mx x my (even); the rest is zero.
/// Plans are estimated, as everywhere. Thread-safe after construction.
class PeriodicTransform {
 public:
  /// mx >= nx and my >= ny, both even.
  PeriodicTransform(int nx, int ny, int mx, int my) : plane_(nx, ny, mx, my) {}

  int nx() const { return plane_.nx(); }
  int ny() const { return plane_.ny(); }
  int mx() const { return plane_.mx(); }
  int my() const { return plane_.my(); }
  /// Extents of the quarter plane: kernels [j][i], spectra [ky][kx].
  int hx() const { return mx() / 2 + 1; }
  int hy() const { return plane_.mh(); }
  std::size_t quarter_size() const { return static_cast<std::size_t>(hx()) * hy(); }

  /// In place: kernel at offsets i <= mx/2, j <= my/2 -> its real spectrum divided by mx my.
  void spectrum(double* quarter) const;

  /// out = convolution of `in` with the kernel of the given spectrum; `out` and `in` may be equal.
  /// `work` is scratch that the caller keeps from call to call.
  void filter(const double* in, const double* quarter, double* out, ComplexField& work) const;

  /// Operations of one filter, up to a constant common to all sizes.
  double cost() const;

 private:
  PaddedTransform plane_;
};

/// Cost of filtering nx rows on a grid of mx x my points, in units of cost().
double filter_cost(int nx, int mx, int my);

}  // namespace samcontact::fft
