// SPDX-License-Identifier: GPL-3.0-or-later
// Two-dimensional real transform of a zero-padded plane without the work for the padding: only the
// nx filled rows are transformed along y, and only nx rows are transformed back.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/plan.hpp"
#include "samcontact/fft/rows.hpp"

namespace samcontact::fft {

/// Planes of nx x ny [i][j] padded to mx x my. Spectra are [ky][kx], ky = 0..my/2, kx = 0..mx-1;
/// successive ky are `stride` complex numbers apart, so that many planes can share one block.
/// Unnormalised: inverse(forward(f)) = mx my f. Plans are estimated, not measured, so that all
/// processes on a machine obtain equal digits. Thread-safe after construction.
class PaddedTransform {
 public:
  /// mx >= nx, my >= ny, both even.
  PaddedTransform(int nx, int ny, int mx, int my);
  /// Padding for a linear convolution.
  PaddedTransform(int nx, int ny)
      : PaddedTransform(nx, ny, convolution_size(nx, 0), convolution_size(ny, 0)) {}

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int mx() const { return mx_; }
  int my() const { return my_; }
  int mh() const { return my_ / 2 + 1; }
  std::size_t spectrum_size() const { return static_cast<std::size_t>(mh()) * mx_; }

  /// Whether a call may use several threads; it uses one if the loop of the caller is parallel.
  enum class Threads { one, many };

  void forward(const double* plane, Complex* spectrum, std::size_t stride, Threads threads) const;
  /// Maps column ky of the input spectra to column ky of the output spectra: mx consecutive numbers
  /// each, in different arrays.
  using Product = std::function<void(int ky, const Complex* in, Complex* out)>;
  /// Forward transform, product and inverse transform of several planes, column by column: the
  /// spectra pass through memory once. May use several threads; out may be the planes, `work` is
  /// scratch owned by the caller.
  void filter(const double* planes, int inputs, const Product& product, int outputs, double* out,
              ComplexField& work) const;

  /// Destroys the spectrum.
  void inverse(Complex* spectrum, double* plane, std::size_t stride, Threads threads) const;

  /// Forward transform on one thread through a lent spectrum of one plane, for strides so long that
  /// rows are better transposed elsewhere. Skips rows [i] of zeros.
  void forward(const double* plane, ComplexField& lent, Complex* spectrum,
               std::size_t stride) const;
  /// Inverse transform of some rows of the plane; the others are unchanged.
  void inverse(const Complex* spectrum, std::size_t stride, ComplexField& lent,
               std::span<const RowRun> rows, double* plane) const;

 private:
  int nx_, ny_, mx_, my_;
  Rows rows_;
  Plan column_forward_, column_inverse_;
};

}  // namespace samcontact::fft
