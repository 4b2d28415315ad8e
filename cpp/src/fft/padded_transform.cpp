// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/padded_transform.hpp"

#include <algorithm>

#include "samcontact/base/threads.hpp"

namespace samcontact::fft {

PaddedTransform::PaddedTransform(int nx, int ny, int mx, int my)
    : nx_(nx),
      ny_(ny),
      mx_(mx),
      my_(my),
      rows_(ny_, my_),
      column_forward_(plan_line(mx_, FFTW_FORWARD)),
      column_inverse_(plan_line(mx_, FFTW_BACKWARD)) {}

void PaddedTransform::forward(const double* plane, Complex* spectrum, std::size_t stride,
                              Threads threads) const {
  const int h = mh();
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= worth_threads_cells)
  {
    rows_.forward(plane, nx_, spectrum, stride);
    ComplexField padded(mx_);
#pragma omp for schedule(static)
    for (int ky = 0; ky < h; ++ky) {
      Complex* column = spectrum + ky * stride;
      std::copy_n(column, nx_, padded.data());
      fftw_execute_dft(column_forward_.get(), raw(padded.data()), raw(column));
    }
  }
}

void PaddedTransform::inverse(Complex* spectrum, double* plane, std::size_t stride,
                              Threads threads) const {
  const int h = mh();
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= worth_threads_cells)
  {
    ComplexField line(mx_);
#pragma omp for schedule(static)
    for (int ky = 0; ky < h; ++ky) {
      Complex* column = spectrum + ky * stride;
      fftw_execute_dft(column_inverse_.get(), raw(column), raw(line.data()));
      std::copy_n(line.data(), nx_, column);
    }
    rows_.inverse(spectrum, stride, nx_, plane);
  }
}

void PaddedTransform::forward(const double* plane, ComplexField& lent, Complex* spectrum,
                              std::size_t stride) const {
  const auto is_empty = [&](int i) {
    const double* row = plane + static_cast<std::ptrdiff_t>(i) * ny_;
    return std::all_of(row, row + ny_, [](double v) { return v == 0; });
  };
  int first = 0, last = nx_;
  while (first < last && is_empty(first)) ++first;
  while (first < last && is_empty(last - 1)) --last;
  lent.resize(spectrum_size());
  // A team of its own, which shares the loop over rows with no other.
#pragma omp parallel if (false)
  rows_.forward(plane + static_cast<std::ptrdiff_t>(first) * ny_, last - first, lent.data() + first,
                mx_);
  for (int ky = 0; ky < mh(); ++ky) {
    Complex* column = lent.data() + static_cast<std::ptrdiff_t>(ky) * mx_;
    std::fill(column, column + first, Complex{});
    std::fill(column + last, column + mx_, Complex{});
    fftw_execute_dft(column_forward_.get(), raw(column), raw(spectrum + ky * stride));
  }
}

void PaddedTransform::inverse(const Complex* spectrum, std::size_t stride, ComplexField& lent,
                              int first, int count, double* plane) const {
  lent.resize(spectrum_size());
  for (int ky = 0; ky < mh(); ++ky) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): from another place they are only read.
    auto* from = const_cast<Complex*>(spectrum + ky * stride);
    fftw_execute_dft(column_inverse_.get(), raw(from),
                     raw(lent.data() + static_cast<std::ptrdiff_t>(ky) * mx_));
  }
#pragma omp parallel if (false)
  rows_.inverse(lent.data() + first, mx_, count, plane + static_cast<std::ptrdiff_t>(first) * ny_);
}

}  // namespace samcontact::fft
