// SPDX-License-Identifier: GPL-3.0-or-later
// Spectra of influence coefficients: the spectrum of a kernel that is even or odd in x and in y is
// (-i)^(number of odd directions) times a real quarter plane.
#pragma once

#include "samcontact/fft/padded_transform.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::fft {

/// Real quarter spectra of kernels sampled at offsets i >= 0, j >= 0. Planning of FFTW's transforms
/// for even and odd sequences would take longer than these transforms.
class ParitySpectrum {
 public:
  ParitySpectrum(int mx, int my);
  explicit ParitySpectrum(const PaddedTransform& transform)
      : ParitySpectrum(transform.mx(), transform.my()) {}

  /// Extents of the quarter plane [j][i] of samples and, in the same storage, [ky][kx] of spectra.
  int hx() const { return mx_ / 2 + 1; }
  int hy() const { return my_ / 2 + 1; }
  std::size_t size() const { return static_cast<std::size_t>(hx()) * hy(); }

  /// quarter[j hx + i] = kernel(i, j) on entry (beyond the last needed offset: 0), the real quarter
  /// of the spectrum divided by mx my on return: kernel^ = (-i)^(odd_x + odd_y) quarter for kx >= 0
  /// and kernel^(-kx) = +-kernel^(kx) for even/odd. Thread-safe.
  void transform(double* quarter, bool odd_x, bool odd_y) const;

 private:
  int mx_, my_;
  Plan line_x_, line_y_;
};

}  // namespace samcontact::fft
