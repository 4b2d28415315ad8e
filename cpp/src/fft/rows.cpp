// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/rows.hpp"

#include <algorithm>

namespace samcontact::fft {

Rows::Rows(int n, int m)
    : n_(n), m_(m), forward_(plan_real_lines(m, block)), inverse_(plan_half_spectra(m, block)) {}

void Rows::forward(const double* plane, int count, Complex* columns, std::size_t stride) const {
  const int h = m_ / 2 + 1;
  Field real(static_cast<std::size_t>(block) * m_);
  ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const int rows = std::min(block, count - i0);
    for (int r = 0; r < rows; ++r) {
      const double* row = plane + static_cast<std::size_t>(i0 + r) * n_;
      double* to = real.data() + static_cast<std::size_t>(r) * m_;
      std::copy(row, row + n_, to);
      std::fill(to + n_, to + m_, 0.0);
    }
    fftw_execute_dft_r2c(forward_.get(), real.data(), raw(half.data()));
    for (int ky = 0; ky < h; ++ky) {
      Complex* to = columns + ky * stride + i0;
      for (int r = 0; r < rows; ++r) to[r] = half[static_cast<std::size_t>(r) * h + ky];
    }
  }
}

void Rows::inverse(const Complex* columns, std::size_t stride, int count, double* plane) const {
  const int h = m_ / 2 + 1;
  Field real(static_cast<std::size_t>(block) * m_);
  ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const int rows = std::min(block, count - i0);
    for (int ky = 0; ky < h; ++ky) {
      const Complex* from = columns + ky * stride + i0;
      for (int r = 0; r < rows; ++r) half[static_cast<std::size_t>(r) * h + ky] = from[r];
    }
    fftw_execute_dft_c2r(inverse_.get(), raw(half.data()), real.data());
    for (int r = 0; r < rows; ++r) {
      const auto row = real.begin() + static_cast<std::size_t>(r) * m_;
      std::copy(row, row + n_, plane + static_cast<std::size_t>(i0 + r) * n_);
    }
  }
}

}  // namespace samcontact::fft
