// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/parity_spectrum.hpp"

#include <algorithm>

namespace samcontact::fft {
namespace {

constexpr int block = 8;  // columns at a time: one cache line of each row

/// The half spectra of sequences that are even or odd in m places, two at a time as real and
/// imaginary part: each has a real spectrum, or an imaginary one.
class Lines {
 public:
  Lines(const Plan& plan, int m, bool odd)
      : plan_(plan), h_(m / 2 + 1), odd_(odd), line_(m), spectrum_(m) {}

  /// In place: m/2 + 1 samples, whose real spectrum takes their place times `scale`.
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

}  // namespace

ParitySpectrum::ParitySpectrum(int mx, int my)
    : mx_(mx),
      my_(my),
      line_x_(plan_line(mx, FFTW_FORWARD)),
      line_y_(plan_line(my, FFTW_FORWARD)) {}

void ParitySpectrum::transform(double* quarter, bool odd_x, bool odd_y) const {
  const int h = hy(), width = hx();
  Field rest(width);  // stands in for the row after the last
  Lines rows(line_x_, mx_, odd_x);
  for (int j = 0; j < h; j += 2) {
    double* row = quarter + static_cast<std::size_t>(j) * width;
    rows.transform(row, j + 1 < h ? row + width : rest.data(), 1.0);
  }
  const double scale = 1.0 / (static_cast<double>(mx_) * my_);
  Lines columns(line_y_, my_, odd_y);
  Field turned(static_cast<std::size_t>(block) * h, 0.0);
  for (int i0 = 0; i0 < width; i0 += block) {
    const int count = std::min(block, width - i0);
    for (int j = 0; j < h; ++j) {
      const double* from = quarter + static_cast<std::size_t>(j) * width + i0;
      for (int c = 0; c < count; ++c) turned[static_cast<std::size_t>(c) * h + j] = from[c];
    }
    for (int c = 0; c < count; c += 2) {
      double* column = turned.data() + static_cast<std::size_t>(c) * h;
      columns.transform(column, column + h, scale);
    }
    for (int k = 0; k < h; ++k) {
      double* to = quarter + static_cast<std::size_t>(k) * width + i0;
      for (int c = 0; c < count; ++c) to[c] = turned[static_cast<std::size_t>(c) * h + k];
    }
  }
}

}  // namespace samcontact::fft
