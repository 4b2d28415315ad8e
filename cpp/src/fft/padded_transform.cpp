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

}  // namespace samcontact::fft
