// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/parity_spectrum.hpp"

#include <algorithm>

#include "samcontact/base/threads.hpp"

namespace samcontact::fft {
namespace {

constexpr int columns_at_once = 8;  // columns at a time: one cache line of each row

/// Half spectra of sequences that are even or odd in m points, two at a time as real and imaginary
/// part: each has a real spectrum, or an imaginary one.
class Lines {
 public:
  Lines(const Plan& plan, int m, bool odd)
      : plan_(plan), h_(m / 2 + 1), odd_(odd), line_(m), spectrum_(m) {}

  /// In place: m/2 + 1 samples are replaced by their real spectrum times `scale`.
  void transform(double* first, double* second, double scale) {
    const std::size_t m = line_.size();
    for (int i = 0; i < h_; ++i) line_[i] = {first[i], second[i]};
    // An odd sequence is zero at both of its self-mirrored ends.
    if (odd_) line_[0] = line_[h_ - 1] = 0.0;
    const double sign = odd_ ? -1.0 : 1.0;
    for (std::size_t i = h_; i < m; ++i) line_[i] = sign * line_[m - i];
    fftw_execute_dft(plan_.get(), raw(line_.data()), raw(spectrum_.data()));
    for (int k = 0; k < h_; ++k) {
      const Complex z = scale * spectrum_[k];
      first[k] = odd_ ? -z.imag() : z.real();
      second[k] = odd_ ? z.real() : z.imag();
    }
  }

 private:
  const Plan& plan_;
  int h_;
  bool odd_;
  ComplexField line_, spectrum_;
};

/// `count` neighbouring columns of rows that are `width` numbers long; `rotated` is a transposed
/// copy.
void transform_columns(double* first, int count, int width, Lines& columns, double scale,
                       Field& rotated) {
  const std::size_t h = rotated.size() / columns_at_once;
  for (std::size_t j = 0; j < h; ++j) {
    for (int c = 0; c < count; ++c) rotated[c * h + j] = first[j * width + c];
  }
  // Columns are transformed in pairs, and the rounding of one depends on the other. Zeros complete
  // the last pair: what the last block left here would depend on the number of threads.
  if (count % 2 == 1) std::fill_n(rotated.data() + count * h, h, 0.0);
  for (int c = 0; c < count; c += 2) {
    double* column = rotated.data() + c * h;
    columns.transform(column, column + h, scale);
  }
  for (std::size_t k = 0; k < h; ++k) {
    for (int c = 0; c < count; ++c) first[k * width + c] = rotated[c * h + k];
  }
}

}  // namespace

ParitySpectrum::ParitySpectrum(int mx, int my)
    : mx_(mx),
      my_(my),
      line_x_(plan_line(mx, FFTW_FORWARD)),
      line_y_(plan_line(my, FFTW_FORWARD)) {}

void ParitySpectrum::transform(double* quarter, bool odd_x, bool odd_y) const {
  const int h = hy(), width = hx();
  const double scale = 1.0 / (static_cast<double>(mx_) * my_);
#pragma omp parallel if (static_cast<std::ptrdiff_t>(size()) >= min_parallel_cells)
  {
    Field rest(width);  // stands for the row after the last
    Lines rows(line_x_, mx_, odd_x);
#pragma omp for schedule(static)
    for (int j = 0; j < h; j += 2) {
      double* row = quarter + static_cast<std::size_t>(j) * width;
      const std::ptrdiff_t values = j + 1 < h ? 2 * width : width;
      // Rows beyond the last offset.
      if (std::all_of(row, row + values, [](double v) { return v == 0; })) continue;
      rows.transform(row, j + 1 < h ? row + width : rest.data(), 1.0);
    }
    Lines columns(line_y_, my_, odd_y);
    Field rotated(static_cast<std::size_t>(columns_at_once) * h, 0.0);
#pragma omp for schedule(static)
    for (int i0 = 0; i0 < width; i0 += columns_at_once) {
      transform_columns(quarter + i0, std::min(columns_at_once, width - i0), width, columns, scale,
                        rotated);
    }
  }
}

}  // namespace samcontact::fft
