// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "samcontact/base/multiversion.hpp"

// Even and odd samples of a row are real and imaginary part of a complex row of half the length.
// FFTW needs a millisecond to plan a real transform, and this is not slower. Short rows are stored
// side by side, eight of them [j][row], so that the passes before and after the transform need no
// shuffling. Long ones, of which eight do not stay in the fastest cache, follow each other: their
// transforms take half the time.

namespace samcontact::fft {
namespace {

constexpr std::ptrdiff_t block = 8;  // rows at a time: one 128-byte run per ky
constexpr std::ptrdiff_t ahead = 8;  // rows of columns by which prefetching is ahead
constexpr std::ptrdiff_t chunk = 8;  // numbers of following rows, transposed at a time

/// Successive rows of columns are pages apart, which processors do not predict.
template <int for_writing>
inline void fetch(const double* run) {
  __builtin_prefetch(run, for_writing);
  __builtin_prefetch(run + block, for_writing);
}

/// Converts eight rows of n cells to their pairs of samples, and back. For odd n the last pair
/// contains a zero.
SAMCONTACT_MULTIVERSION
void gather(const double* plane, std::ptrdiff_t n, double* samples) {
  for (std::ptrdiff_t j = 0; j + 1 < n; j += 2) {
    for (std::ptrdiff_t r = 0; r < block; ++r) {
      const double* two = plane + r * n + j;
      std::memcpy(samples + 2 * r, two, 2 * sizeof(double));
    }
    samples += 2 * block;
  }
  for (std::ptrdiff_t r = 0; n % 2 && r < block; ++r) {
    samples[2 * r] = plane[(r + 1) * n - 1];
    samples[2 * r + 1] = 0.0;
  }
}

SAMCONTACT_MULTIVERSION
void scatter(const double* samples, std::ptrdiff_t n, double* plane) {
  for (std::ptrdiff_t j = 0; j + 1 < n; j += 2) {
    for (std::ptrdiff_t r = 0; r < block; ++r) {
      double* two = plane + r * n + j;
      std::memcpy(two, samples + 2 * r, 2 * sizeof(double));
    }
    samples += 2 * block;
  }
  for (std::ptrdiff_t r = 0; n % 2 && r < block; ++r) {
    plane[(r + 1) * n - 1] = samples[2 * r];
  }
}

/// The first and last numbers of the spectra of the real rows, from the first of the complex ones.
void unfold_ends(const double* halves, double* first, double* last) {
  for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
    first[r] = halves[r] + halves[r + 1];
    last[r] = halves[r] - halves[r + 1];
    first[r + 1] = last[r + 1] = 0.0;
  }
}

void fold_ends(const double* first, const double* last, double* halves) {
  for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
    halves[r] = first[r] + last[r];
    halves[r + 1] = first[r] - last[r];
  }
}

/// Spectra of the real rows from those of the complex rows, at `count` wavenumbers k that ascend
/// from the low pointers and at h - k that descend from the high ones. Successive wavenumbers are
/// `stride` numbers apart.
SAMCONTACT_MULTIVERSION
void unfold(const double* low, const double* high, std::ptrdiff_t count, const Complex* twiddle,
            double* to_low, double* to_high, std::ptrdiff_t stride) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    fetch<1>(to_low + ahead * stride);
    fetch<1>(to_high - ahead * stride);
    const double c = 0.5 * twiddle[k].real(), s = 0.5 * twiddle[k].imag();
    for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
      const double even_re = 0.5 * (low[r] + high[r]), even_im = 0.5 * (low[r + 1] - high[r + 1]);
      const double odd_re = low[r + 1] + high[r + 1], odd_im = high[r] - low[r];
      const double re = odd_re * c - odd_im * s, im = odd_re * s + odd_im * c;
      to_low[r] = even_re + re;
      to_low[r + 1] = even_im + im;
      to_high[r] = even_re - re;
      to_high[r + 1] = im - even_im;
    }
    low += 2 * block;
    high -= 2 * block;
    to_low += stride;
    to_high -= stride;
  }
}

SAMCONTACT_MULTIVERSION
void fold(const double* low, const double* high, std::ptrdiff_t stride, int count,
          const Complex* twiddle, double* to_low, double* to_high) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    fetch<0>(low + ahead * stride);
    fetch<0>(high - ahead * stride);
    const double c = twiddle[k].real(), s = twiddle[k].imag();
    for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
      const double even_re = low[r] + high[r], even_im = low[r + 1] - high[r + 1];
      const double re = low[r] - high[r], im = low[r + 1] + high[r + 1];
      const double odd_re = re * c + im * s, odd_im = im * c - re * s;
      to_low[r] = even_re - odd_im;
      to_low[r + 1] = even_im + odd_re;
      to_high[r] = even_re + odd_im;
      to_high[r + 1] = odd_re - even_im;
    }
    low += stride;
    high -= stride;
    to_low += 2 * block;
    to_high -= 2 * block;
  }
}

/// Copies `count` numbers of each of eight lines, `pitch` apart, side by side, and back.
SAMCONTACT_MULTIVERSION
void from_lines(const double* lines, std::ptrdiff_t pitch, std::ptrdiff_t count,
                double* side_by_side) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    for (std::ptrdiff_t r = 0; r < block; ++r) {
      std::memcpy(side_by_side + 2 * r, lines + r * pitch + 2 * k, 2 * sizeof(double));
    }
    side_by_side += 2 * block;
  }
}

SAMCONTACT_MULTIVERSION
void to_lines(const double* side_by_side, std::ptrdiff_t count, double* lines,
              std::ptrdiff_t pitch) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    for (std::ptrdiff_t r = 0; r < block; ++r) {
      std::memcpy(lines + r * pitch + 2 * k, side_by_side + 2 * r, 2 * sizeof(double));
    }
    side_by_side += 2 * block;
  }
}

/// Distance between following rows: equal positions of eight rows must not compete for one cache
/// set.
std::ptrdiff_t row_pitch(int h) { return (h + 3) / 4 * 4 + 4; }

double* parts(Complex* z) { return reinterpret_cast<double*>(z); }
const double* parts(const Complex* z) { return reinterpret_cast<const double*>(z); }

}  // namespace

/// Work space for a block of rows, one per thread, kept between calls.
struct Rows::Room {
  ComplexField samples, halves, columns;
  Field rows;
};

std::vector<RowRun> runs_of(std::span<const char> used) {
  const int count = static_cast<int>(used.size());
  std::vector<RowRun> runs;
  for (int i = 0; i < count;) {
    if (!used[i]) {
      ++i;
      continue;
    }
    if (runs.empty() || runs.back().first + runs.back().count != i) runs.push_back({i, 0});
    const int rows = std::min(static_cast<int>(block), count - i);
    runs.back().count += rows;
    i += rows;
  }
  return runs;
}

Rows::Rows(int n, int m)
    : n_(n), m_(m), side_by_side_(m <= longest_side_by_side), twiddle_(m / 4 + std::size_t{1}) {
  const int h = m / 2;
  const auto plan = [&](int sign) {
    return side_by_side_ ? plan_lines_side_by_side(h, static_cast<int>(block), sign)
                         : plan_line(h, sign);
  };
  forward_ = plan(FFTW_FORWARD);
  inverse_ = plan(FFTW_BACKWARD);
  for (int k = 0; k <= m / 4; ++k) twiddle_[k] = std::polar(1.0, -2.0 * std::numbers::pi * k / m);
}

/// rest: rows of n numbers that are not a whole block.
Rows::Room& Rows::room_for(std::ptrdiff_t rest) const {
  static thread_local Room room;
  const auto at_least = [](auto& field, std::size_t size) {
    if (field.size() < size) field.resize(size);
  };
  const int h = m_ / 2;
  at_least(room.samples, static_cast<std::size_t>(side_by_side_ ? block : 1) * h);
  at_least(room.halves, static_cast<std::size_t>(block) * (side_by_side_ ? h : row_pitch(h)));
  if (rest > 0) at_least(room.rows, static_cast<std::size_t>(block) * n_);
  if (rest > 0) at_least(room.columns, static_cast<std::size_t>(block) * (h + 1));
  return room;
}

/// Transform of one block, whose columns are `step` numbers apart.
void Rows::forward_side_by_side(const double* plane, Room& room, double* columns,
                                std::ptrdiff_t step) const {
  const int h = m_ / 2;
  double* halves = parts(room.halves.data());
  gather(plane, n_, parts(room.samples.data()));
  fftw_execute_dft(forward_.get(), raw(room.samples.data()), raw(room.halves.data()));
  unfold_ends(halves, columns, columns + h * step);
  unfold(halves + 2 * block, halves + 2 * block * (h - 1), h / 2, twiddle_.data() + 1,
         columns + step, columns + (h - 1) * step, step);
}

void Rows::inverse_side_by_side(const double* columns, std::ptrdiff_t step, Room& room,
                                double* plane) const {
  const int h = m_ / 2;
  double* halves = parts(room.halves.data());
  fold_ends(columns, columns + h * step, halves);
  fold(columns + step, columns + (h - 1) * step, step, h / 2, twiddle_.data() + 1,
       halves + 2 * block, halves + 2 * block * (h - 1));
  fftw_execute_dft(inverse_.get(), raw(room.halves.data()), raw(room.samples.data()));
  scatter(parts(room.samples.data()), n_, plane);
}

void Rows::forward_lines(const double* plane, std::ptrdiff_t rows, Room& room, double* columns,
                         std::ptrdiff_t step) const {
  const std::ptrdiff_t h = m_ / 2;
  const std::ptrdiff_t pitch = 2 * row_pitch(h), last = 2 * block * (chunk - 1);
  double* lines = parts(room.halves.data());
  for (std::ptrdiff_t r = 0; r < rows; ++r) {
    std::copy_n(plane + r * n_, n_, parts(room.samples.data()));
    fftw_execute_dft(forward_.get(), raw(room.samples.data()),
                     raw(room.halves.data() + r * pitch / 2));
  }
  alignas(64) double low[2 * block * chunk], high[2 * block * chunk];
  from_lines(lines, pitch, 1, low);
  unfold_ends(low, columns, columns + h * step);
  for (std::ptrdiff_t k = 1; k <= h / 2; k += chunk) {
    const std::ptrdiff_t count = std::min(chunk, h / 2 + 1 - k);
    from_lines(lines + 2 * k, pitch, count, low);
    from_lines(lines + 2 * (h - k - count + 1), pitch, count, high + 2 * block * (chunk - count));
    unfold(low, high + last, count, twiddle_.data() + k, columns + k * step,
           columns + (h - k) * step, step);
  }
}

void Rows::inverse_lines(const double* columns, std::ptrdiff_t step, std::ptrdiff_t rows,
                         Room& room, double* plane) const {
  const std::ptrdiff_t h = m_ / 2;
  const std::ptrdiff_t pitch = 2 * row_pitch(h), last = 2 * block * (chunk - 1);
  double* lines = parts(room.halves.data());
  alignas(64) double low[2 * block * chunk], high[2 * block * chunk];
  fold_ends(columns, columns + h * step, low);
  to_lines(low, 1, lines, pitch);
  for (std::ptrdiff_t k = 1; k <= h / 2; k += chunk) {
    const std::ptrdiff_t count = std::min(chunk, h / 2 + 1 - k);
    fold(columns + k * step, columns + (h - k) * step, step, count, twiddle_.data() + k, low,
         high + last);
    to_lines(low, count, lines + 2 * k, pitch);
    to_lines(high + 2 * block * (chunk - count), count, lines + 2 * (h - k - count + 1), pitch);
  }
  for (std::ptrdiff_t r = 0; r < rows; ++r) {
    fftw_execute_dft(inverse_.get(), raw(room.halves.data() + r * pitch / 2),
                     raw(room.samples.data()));
    std::copy_n(parts(room.samples.data()), n_, plane + r * n_);
  }
}

void Rows::forward(const double* plane, int count, Complex* columns, std::size_t stride) const {
  const int h = m_ / 2;
  Room& room = room_for(count % block);
  const std::ptrdiff_t side = side_by_side_ ? block : 1;
  double* samples = parts(room.samples.data());
  std::fill(samples + side * (n_ + n_ % 2 * side_by_side_), samples + side * m_, 0.0);
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const std::ptrdiff_t rows = std::min<std::ptrdiff_t>(block, count - i0);
    const bool whole = rows == block;
    const double* from = plane + static_cast<std::size_t>(i0) * n_;
    double* to = parts(whole ? columns + i0 : room.columns.data());
    const std::ptrdiff_t step = 2 * (whole ? static_cast<std::ptrdiff_t>(stride) : block);
    if (side_by_side_) {
      if (!whole) from = std::copy_n(from, rows * n_, room.rows.data()) - rows * n_;
      forward_side_by_side(from, room, to, step);
    } else {
      forward_lines(from, rows, room, to, step);
    }
    for (int k = 0; !whole && k <= h; ++k) {
      std::copy_n(room.columns.data() + block * k, rows, columns + k * stride + i0);
    }
  }
}

void Rows::inverse(const Complex* columns, std::size_t stride, int count, double* plane) const {
  const int h = m_ / 2;
  Room& room = room_for(count % block);
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const std::ptrdiff_t rows = std::min<std::ptrdiff_t>(block, count - i0);
    const bool whole = rows == block;
    for (int k = 0; !whole && k <= h; ++k) {
      std::copy_n(columns + k * stride + i0, rows, room.columns.data() + block * k);
    }
    const double* from = parts(whole ? columns + i0 : room.columns.data());
    const std::ptrdiff_t step = 2 * (whole ? static_cast<std::ptrdiff_t>(stride) : block);
    double* to = plane + static_cast<std::size_t>(i0) * n_;
    if (!side_by_side_) {
      inverse_lines(from, step, rows, room, to);
      continue;
    }
    inverse_side_by_side(from, step, room, whole ? to : room.rows.data());
    if (!whole) std::copy_n(room.rows.data(), rows * n_, to);
  }
}

}  // namespace samcontact::fft
