// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/periodic_transform.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"

namespace samcontact::fft {

double filter_cost(int nx, int mx, int my) {
  return 0.5 * nx * my * std::log2(my) + (0.5 * my + 1) * mx * std::log2(mx);
}

PeriodicTransform::PeriodicTransform(int nx, int ny, int mx, int my)
    : nx_(nx),
      ny_(ny),
      mx_(mx),
      my_(my),
      many_threads_(static_cast<std::size_t>(mx) * (my / 2 + 1) >= worth_threads_cells),
      rows_(ny, my),
      column_forward_(plan_line(mx, FFTW_FORWARD)),
      column_inverse_(plan_line(mx, FFTW_BACKWARD)) {}

double PeriodicTransform::cost() const { return filter_cost(nx_, mx_, my_); }

void PeriodicTransform::spectrum(double* quarter) const {
  ParitySpectrum(mx_, my_).transform(quarter, false, false);
}

void PeriodicTransform::filter(const double* in, const double* quarter, double* out,
                               ComplexField& work) const {
  work.resize(static_cast<std::size_t>(hy()) * mx_);
#pragma omp parallel if (many_threads_)
  rows_.forward(in, nx_, work.data(), mx_);
  filter_columns(quarter, work);
#pragma omp parallel if (many_threads_)
  rows_.inverse(work.data(), mx_, nx_, out);
}

void PeriodicTransform::filter_columns(const double* quarter, ComplexField& work) const {
  const int half = mx_ / 2;
#pragma omp parallel if (many_threads_)
  {
    ComplexField spectrum(mx_);
#pragma omp for schedule(static)
    for (int ky = 0; ky < hy(); ++ky) {
      Complex* column = work.data() + static_cast<std::size_t>(ky) * mx_;
      const double* factor = quarter + static_cast<std::size_t>(ky) * hx();
      std::fill(column + nx_, column + mx_, Complex{});
      fftw_execute_dft(column_forward_.get(), raw(column), raw(spectrum.data()));
      for (int kx = 0; kx <= half; ++kx) spectrum[kx] *= factor[kx];
      for (int kx = half + 1; kx < mx_; ++kx) spectrum[kx] *= factor[mx_ - kx];
      fftw_execute_dft(column_inverse_.get(), raw(spectrum.data()), raw(column));
    }
  }
}

}  // namespace samcontact::fft
