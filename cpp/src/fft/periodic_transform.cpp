// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/periodic_transform.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/threads.hpp"

namespace samcontact::fft {

double filter_cost(int nx, int mx, int my) {
  return 0.5 * nx * my * std::log2(my) + (0.5 * my + 1) * mx * std::log2(mx);
}

PeriodicTransform::PeriodicTransform(int nx, int ny, int mx, int my)
    : nx_(nx),
      ny_(ny),
      mx_(mx),
      my_(my),
      many_threads_(static_cast<std::size_t>(mx) * (my / 2 + 1) >= worth_threads_cells) {
  Field real(static_cast<std::size_t>(block) * my_);
  ComplexField half(static_cast<std::size_t>(block) * hy());
  ComplexField column(mx_);
  const std::lock_guard lock(planner_mutex());
  rows_forward_.reset(fftw_plan_many_dft_r2c(1, &my_, block, real.data(), nullptr, 1, my_,
                                             raw(half.data()), nullptr, 1, hy(), FFTW_ESTIMATE));
  rows_inverse_.reset(fftw_plan_many_dft_c2r(1, &my_, block, raw(half.data()), nullptr, 1, hy(),
                                             real.data(), nullptr, 1, my_, FFTW_ESTIMATE));
  column_forward_.reset(
      fftw_plan_dft_1d(mx_, raw(column.data()), raw(column.data()), FFTW_FORWARD, FFTW_ESTIMATE));
  column_inverse_.reset(
      fftw_plan_dft_1d(mx_, raw(column.data()), raw(column.data()), FFTW_BACKWARD, FFTW_ESTIMATE));
}

double PeriodicTransform::cost() const { return filter_cost(nx_, mx_, my_); }

void PeriodicTransform::spectrum(double* quarter) const {
  Plan plan;
  {
    const std::lock_guard lock(planner_mutex());
    plan.reset(fftw_plan_r2r_2d(hy(), hx(), quarter, quarter, FFTW_REDFT00, FFTW_REDFT00,
                                FFTW_ESTIMATE | FFTW_UNALIGNED));
  }
  fftw_execute(plan.get());
  const double scale = 1.0 / (static_cast<double>(mx_) * my_);
  std::for_each(quarter, quarter + quarter_size(), [scale](double& v) { v *= scale; });
}

void PeriodicTransform::filter(const double* in, const double* quarter, double* out,
                               ComplexField& work) const {
  work.resize(static_cast<std::size_t>(hy()) * mx_);
  forward_rows(in, work);
  filter_columns(quarter, work);
  inverse_rows(work, out);
}

void PeriodicTransform::forward_rows(const double* in, ComplexField& work) const {
  const int h = hy();
#pragma omp parallel if (many_threads_)
  {
    Field real(static_cast<std::size_t>(block) * my_);
    ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
    for (int i0 = 0; i0 < nx_; i0 += block) {
      const int rows = std::min(block, nx_ - i0);
      for (int r = 0; r < rows; ++r) {
        const double* row = in + static_cast<std::size_t>(i0 + r) * ny_;
        double* to = real.data() + static_cast<std::size_t>(r) * my_;
        std::copy(row, row + ny_, to);
        std::fill(to + ny_, to + my_, 0.0);
      }
      fftw_execute_dft_r2c(rows_forward_.get(), real.data(), raw(half.data()));
      for (int ky = 0; ky < h; ++ky) {
        Complex* to = work.data() + static_cast<std::size_t>(ky) * mx_ + i0;
        for (int r = 0; r < rows; ++r) to[r] = half[static_cast<std::size_t>(r) * h + ky];
      }
    }
  }
}

void PeriodicTransform::filter_columns(const double* quarter, ComplexField& work) const {
  const int half = mx_ / 2;
#pragma omp parallel for schedule(static) if (many_threads_)
  for (int ky = 0; ky < hy(); ++ky) {
    Complex* column = work.data() + static_cast<std::size_t>(ky) * mx_;
    const double* factor = quarter + static_cast<std::size_t>(ky) * hx();
    std::fill(column + nx_, column + mx_, Complex{});
    fftw_execute_dft(column_forward_.get(), raw(column), raw(column));
    for (int kx = 0; kx <= half; ++kx) column[kx] *= factor[kx];
    for (int kx = half + 1; kx < mx_; ++kx) column[kx] *= factor[mx_ - kx];
    fftw_execute_dft(column_inverse_.get(), raw(column), raw(column));
  }
}

void PeriodicTransform::inverse_rows(const ComplexField& work, double* out) const {
  const int h = hy();
#pragma omp parallel if (many_threads_)
  {
    Field real(static_cast<std::size_t>(block) * my_);
    ComplexField half(static_cast<std::size_t>(block) * h);
#pragma omp for schedule(static)
    for (int i0 = 0; i0 < nx_; i0 += block) {
      const int rows = std::min(block, nx_ - i0);
      for (int ky = 0; ky < h; ++ky) {
        const Complex* from = work.data() + static_cast<std::size_t>(ky) * mx_ + i0;
        for (int r = 0; r < rows; ++r) half[static_cast<std::size_t>(r) * h + ky] = from[r];
      }
      fftw_execute_dft_c2r(rows_inverse_.get(), raw(half.data()), real.data());
      for (int r = 0; r < rows; ++r) {
        const auto row = real.begin() + static_cast<std::size_t>(r) * my_;
        std::copy(row, row + ny_, out + static_cast<std::size_t>(i0 + r) * ny_);
      }
    }
  }
}

}  // namespace samcontact::fft
