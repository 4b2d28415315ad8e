// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/padded_transform.hpp"

#include <algorithm>
#include <vector>

#include "samcontact/base/threads.hpp"

namespace samcontact::fft {
namespace {

/// Rows of n numbers that are not all zero.
std::vector<RowRun> rows_in_use(const double* plane, int count, int n) {
  std::vector<char> used(count);
  for (int i = 0; i < count; ++i, plane += n) {
    used[i] = std::any_of(plane, plane + n, [](double v) { return v != 0; });
  }
  return runs_of(used);
}

/// Prefetches a line of numbers: transforms read them in an order that processors do not predict.
void fetch(const Complex* line, int count) {
  for (int x = 0; x < count; x += 4) __builtin_prefetch(line + x);
}

/// Distance between columns of n numbers that are written in blocks of rows: an odd number of
/// blocks, so that successive columns do not compete for one cache set.
std::size_t column_pitch(int n) {
  const std::size_t blocks = (n + 7) / 8;
  return 8 * (blocks + 1 - blocks % 2);
}

}  // namespace

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
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= min_parallel_cells)
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

void PaddedTransform::filter(const double* planes, int inputs, const Product& product, int outputs,
                             double* out, ComplexField& work) const {
  const std::size_t pitch = column_pitch(nx_), size = mh() * pitch,
                    plane = static_cast<std::size_t>(nx_) * ny_;
  work.resize(std::max(inputs, outputs) * size);
#pragma omp parallel if (spectrum_size() >= min_parallel_cells)
  {
    for (int c = 0; c < inputs; ++c) {
      rows_.forward(planes + c * plane, nx_, work.data() + c * size, pitch);
    }
    ComplexField padded(mx_), spectra(static_cast<std::size_t>(inputs) * mx_),
        results(static_cast<std::size_t>(outputs) * mx_);
#pragma omp for schedule(static)
    for (int ky = 0; ky < mh(); ++ky) {
      Complex* column = work.data() + ky * pitch;
      for (std::ptrdiff_t c = 0; c < inputs; ++c) {
        std::copy_n(column + c * size, nx_, padded.data());
        fftw_execute_dft(column_forward_.get(), raw(padded.data()), raw(spectra.data() + c * mx_));
      }
      product(ky, spectra.data(), results.data());
      for (std::ptrdiff_t c = 0; c < outputs; ++c) {
        fftw_execute_dft(column_inverse_.get(), raw(results.data() + c * mx_), raw(spectra.data()));
        std::copy_n(spectra.data(), nx_, column + c * size);
      }
    }
    for (int c = 0; c < outputs; ++c) {
      rows_.inverse(work.data() + c * size, pitch, nx_, out + c * plane);
    }
  }
}

void PaddedTransform::inverse(Complex* spectrum, double* plane, std::size_t stride,
                              Threads threads) const {
  const int h = mh();
#pragma omp parallel if (threads == Threads::many && spectrum_size() >= min_parallel_cells)
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
  const std::vector<RowRun> runs = rows_in_use(plane, nx_, ny_);
  lent.resize(spectrum_size());
  // A separate team, which shares the loop over rows with no other.
#pragma omp parallel if (false)
  for (const auto [first, count] : runs) {
    rows_.forward(plane + static_cast<std::ptrdiff_t>(first) * ny_, count, lent.data() + first,
                  mx_);
  }
  for (int ky = 0; ky < mh(); ++ky) {
    Complex* column = lent.data() + static_cast<std::ptrdiff_t>(ky) * mx_;
    int end = 0;
    for (const auto [first, count] : runs) {
      std::fill(column + end, column + first, Complex{});
      end = first + count;
    }
    std::fill(column + end, column + mx_, Complex{});
    fftw_execute_dft(column_forward_.get(), raw(column), raw(spectrum + ky * stride));
  }
}

void PaddedTransform::inverse(const Complex* spectrum, std::size_t stride, ComplexField& lent,
                              std::span<const RowRun> rows, double* plane) const {
  lent.resize(spectrum_size());
  for (int ky = 0; ky < mh(); ++ky) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): out of place, they are only read.
    auto* from = const_cast<Complex*>(spectrum + ky * stride);
    if (ky + 1 < mh()) fetch(from + stride, mx_);
    fftw_execute_dft(column_inverse_.get(), raw(from),
                     raw(lent.data() + static_cast<std::ptrdiff_t>(ky) * mx_));
  }
#pragma omp parallel if (false)
  for (const auto [first, count] : rows) {
    rows_.inverse(lent.data() + first, mx_, count,
                  plane + static_cast<std::ptrdiff_t>(first) * ny_);
  }
}

}  // namespace samcontact::fft
