// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/padded_transform.hpp"

#include <algorithm>

#include "samcontact/base/threads.hpp"

namespace samcontact::fft {

PaddedTransform::PaddedTransform(int nx, int ny, int least_mx, int least_my)
    : nx_(nx),
      ny_(ny),
      mx_(good_even_size(std::max(2 * nx - 1, least_mx))),
      my_(good_even_size(std::max(2 * ny - 1, least_my))) {
  Field real(static_cast<std::size_t>(block) * my_);
  ComplexField half(static_cast<std::size_t>(block) * mh());
  ComplexField column(mx_);
  const std::lock_guard lock(planner_mutex());
  rows_forward_.reset(fftw_plan_many_dft_r2c(1, &my_, block, real.data(), nullptr, 1, my_,
                                             raw(half.data()), nullptr, 1, mh(), FFTW_ESTIMATE));
  rows_inverse_.reset(fftw_plan_many_dft_c2r(1, &my_, block, raw(half.data()), nullptr, 1, mh(),
                                             real.data(), nullptr, 1, my_, FFTW_ESTIMATE));
  column_forward_.reset(
      fftw_plan_dft_1d(mx_, raw(column.data()), raw(column.data()), FFTW_FORWARD, FFTW_ESTIMATE));
  column_inverse_.reset(
      fftw_plan_dft_1d(mx_, raw(column.data()), raw(column.data()), FFTW_BACKWARD, FFTW_ESTIMATE));
}

void PaddedTransform::forward(const double* plane, Complex* spectrum, std::size_t stride,
                              Threads threads) const {
  const int h = mh();
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= worth_threads_cells)
  {
    Field real(static_cast<std::size_t>(block) * my_);
    ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
    for (int i0 = 0; i0 < nx_; i0 += block) {
      const int rows = std::min(block, nx_ - i0);
      for (int r = 0; r < rows; ++r) {
        const double* row = plane + static_cast<std::size_t>(i0 + r) * ny_;
        std::copy(row, row + ny_, real.begin() + static_cast<std::size_t>(r) * my_);
      }
      fftw_execute_dft_r2c(rows_forward_.get(), real.data(), raw(half.data()));
      for (int ky = 0; ky < h; ++ky) {
        Complex* to = spectrum + ky * stride + i0;
        for (int r = 0; r < rows; ++r) to[r] = half[static_cast<std::size_t>(r) * h + ky];
      }
    }
#pragma omp for schedule(static)
    for (int ky = 0; ky < h; ++ky) {
      Complex* column = spectrum + ky * stride;
      std::fill(column + nx_, column + mx_, Complex{});
      fftw_execute_dft(column_forward_.get(), raw(column), raw(column));
    }
  }
}

void PaddedTransform::inverse(Complex* spectrum, double* plane, std::size_t stride,
                              Threads threads) const {
  const int h = mh();
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= worth_threads_cells)
  {
    Field real(static_cast<std::size_t>(block) * my_);
    ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
    for (int ky = 0; ky < h; ++ky) {
      Complex* column = spectrum + ky * stride;
      fftw_execute_dft(column_inverse_.get(), raw(column), raw(column));
    }
#pragma omp for schedule(static)
    for (int i0 = 0; i0 < nx_; i0 += block) {
      const int rows = std::min(block, nx_ - i0);
      for (int ky = 0; ky < h; ++ky) {
        const Complex* from = spectrum + ky * stride + i0;
        for (int r = 0; r < rows; ++r) half[static_cast<std::size_t>(r) * h + ky] = from[r];
      }
      fftw_execute_dft_c2r(rows_inverse_.get(), raw(half.data()), real.data());
      for (int r = 0; r < rows; ++r) {
        const auto row = real.begin() + static_cast<std::size_t>(r) * my_;
        std::copy(row, row + ny_, plane + static_cast<std::size_t>(i0 + r) * ny_);
      }
    }
  }
}

}  // namespace samcontact::fft
