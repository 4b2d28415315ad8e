// SPDX-License-Identifier: GPL-3.0-or-later
// Two-dimensional real transform of a plane padded with zeros, which skips the padding: only the nx
// filled rows are transformed along y, and only nx rows are brought back.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/plan.hpp"
#include "samcontact/fft/rows.hpp"

namespace samcontact::fft {

/// Planes of nx x ny [i][j] padded to mx x my. Spectra are [ky][kx], ky = 0..my/2, kx = 0..mx-1;
/// successive ky lie `stride` complex numbers apart, so that many planes can share one block.
/// Unnormalised: inverse(forward(f)) = mx my f. Plans are estimated, not measured: the same machine
/// then repeats the same digits in every process. Thread-safe after construction.
class PaddedTransform {
 public:
  /// mx >= nx, my >= ny, both even.
  PaddedTransform(int nx, int ny, int mx, int my);
  /// Pads enough for a linear convolution.
  PaddedTransform(int nx, int ny)
      : PaddedTransform(nx, ny, convolution_size(nx, 0), convolution_size(ny, 0)) {}

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int mx() const { return mx_; }
  int my() const { return my_; }
  int mh() const { return my_ / 2 + 1; }
  std::size_t spectrum_size() const { return static_cast<std::size_t>(mh()) * mx_; }

  /// Whether a call may use several threads itself; off when the caller's loop already does.
  enum class Threads { one, many };

  void forward(const double* plane, Complex* spectrum, std::size_t stride, Threads threads) const;
  /// What makes columns ky of the results' spectra of those of the planes': mx numbers each, one
  /// after the other, in other places.
  using Product = std::function<void(int ky, const Complex* in, Complex* out)>;
  /// Forward, product and inverse of planes one after the other, column by column: the spectra pass
  /// once through memory. May use several threads; out may be the planes, `work` is scratch that
  /// the caller keeps.
  void filter(const double* planes, int inputs, const Product& product, int outputs, double* out,
              ComplexField& work) const;

  /// Destroys the spectrum.
  void inverse(Complex* spectrum, double* plane, std::size_t stride, Threads threads) const;

  /// The same by one thread through a plane's spectrum that the caller lends, where strides are so
  /// long that rows are better transposed elsewhere. Skips rows [i] of zeros.
  void forward(const double* plane, ComplexField& lent, Complex* spectrum,
               std::size_t stride) const;
  /// Some rows of the plane; the others are not touched.
  void inverse(const Complex* spectrum, std::size_t stride, ComplexField& lent,
               std::span<const RowRun> rows, double* plane) const;

 private:
  int nx_, ny_, mx_, my_;
  Rows rows_;
  Plan column_forward_, column_inverse_;
};

}  // namespace samcontact::fft
