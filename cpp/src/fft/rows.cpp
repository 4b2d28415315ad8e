// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "samcontact/base/multiversion.hpp"

// Even and odd samples of a row are real and imaginary part of a complex row of half the length.
// FFTW takes a millisecond to plan a real transform, and this is not slower. Eight rows lie side by
// side, [j][row], so that the passes before and after the transform need no shuffling.

namespace samcontact::fft {
namespace {

constexpr std::ptrdiff_t block = 8;  // rows at a time: one 128-byte run per ky
constexpr std::ptrdiff_t ahead = 8;  // rows of columns that are fetched before they are needed

/// Successive rows of columns are pages apart, which processors do not foresee.
template <int for_writing>
inline void fetch(const double* run) {
  __builtin_prefetch(run, for_writing);
  __builtin_prefetch(run + block, for_writing);
}

/// From eight rows of n cells into their pairs of samples, and back. The last of an odd number is a
/// pair with zero.
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

/// Spectra of the real rows, [k] of h + 1 with `stride` numbers between, from those of the complex
/// ones, [k] of h.
SAMCONTACT_MULTIVERSION
void unfold(const double* halves, int h, const Complex* turn, double* columns, std::size_t stride) {
  double* last = columns + h * stride;
  for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
    columns[r] = halves[r] + halves[r + 1];
    last[r] = halves[r] - halves[r + 1];
    columns[r + 1] = last[r + 1] = 0.0;
  }
  for (int k = 1; k <= h / 2; ++k) {
    const double* low = halves + static_cast<std::size_t>(2 * block) * k;
    const double* high = halves + static_cast<std::size_t>(2 * block) * (h - k);
    double* to_low = columns + k * stride;
    double* to_high = columns + (h - k) * stride;
    fetch<1>(to_low + ahead * stride);
    fetch<1>(to_high - ahead * stride);
    const double c = 0.5 * turn[k].real(), s = 0.5 * turn[k].imag();
    for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
      const double even_re = 0.5 * (low[r] + high[r]), even_im = 0.5 * (low[r + 1] - high[r + 1]);
      const double odd_re = low[r + 1] + high[r + 1], odd_im = high[r] - low[r];
      const double re = odd_re * c - odd_im * s, im = odd_re * s + odd_im * c;
      to_low[r] = even_re + re;
      to_low[r + 1] = even_im + im;
      to_high[r] = even_re - re;
      to_high[r + 1] = im - even_im;
    }
  }
}

SAMCONTACT_MULTIVERSION
void fold(const double* columns, std::size_t stride, int h, const Complex* turn, double* halves) {
  const double* last = columns + h * stride;
  for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
    halves[r] = columns[r] + last[r];
    halves[r + 1] = columns[r] - last[r];
  }
  for (int k = 1; k <= h / 2; ++k) {
    const double* low = columns + k * stride;
    const double* high = columns + (h - k) * stride;
    double* to_low = halves + static_cast<std::size_t>(2 * block) * k;
    double* to_high = halves + static_cast<std::size_t>(2 * block) * (h - k);
    fetch<0>(low + ahead * stride);
    fetch<0>(high - ahead * stride);
    const double c = turn[k].real(), s = turn[k].imag();
    for (std::ptrdiff_t r = 0; r < 2 * block; r += 2) {
      const double even_re = low[r] + high[r], even_im = low[r + 1] - high[r + 1];
      const double re = low[r] - high[r], im = low[r + 1] + high[r + 1];
      const double odd_re = re * c + im * s, odd_im = im * c - re * s;
      to_low[r] = even_re - odd_im;
      to_low[r + 1] = even_im + odd_re;
      to_high[r] = even_re + odd_im;
      to_high[r + 1] = odd_re - even_im;
    }
  }
}

/// Room for a block of rows, of one thread: what it has once taken stays with it.
struct Room {
  ComplexField samples, halves, columns;
  Field rows;
};

/// rest: rows of n numbers that are no whole block.
Room& room_for(int h, std::ptrdiff_t rest, int n) {
  static thread_local Room room;
  const auto at_least = [](auto& field, std::size_t size) {
    if (field.size() < size) field.resize(size);
  };
  at_least(room.samples, static_cast<std::size_t>(block) * h);
  at_least(room.halves, static_cast<std::size_t>(block) * h);
  if (rest > 0) at_least(room.rows, static_cast<std::size_t>(block) * n);
  if (rest > 0) at_least(room.columns, static_cast<std::size_t>(block) * (h + 1));
  return room;
}

double* parts(Complex* z) { return reinterpret_cast<double*>(z); }
const double* parts(const Complex* z) { return reinterpret_cast<const double*>(z); }

}  // namespace

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
    : n_(n),
      m_(m),
      forward_(plan_lines_side_by_side(m / 2, static_cast<int>(block), FFTW_FORWARD)),
      inverse_(plan_lines_side_by_side(m / 2, static_cast<int>(block), FFTW_BACKWARD)),
      turn_(static_cast<std::size_t>(m / 4) + 1) {
  for (int k = 0; k <= m / 4; ++k) turn_[k] = std::polar(1.0, -2.0 * std::numbers::pi * k / m);
}

void Rows::forward(const double* plane, int count, Complex* columns, std::size_t stride) const {
  const int h = m_ / 2;
  Room& room = room_for(h, count % block, n_);
  ComplexField &samples = room.samples, &halves = room.halves, &rest_columns = room.columns;
  Field& rest = room.rows;
  std::fill_n(samples.begin() + block * ((n_ + 1) / 2), block * (h - (n_ + 1) / 2), Complex{});
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const std::ptrdiff_t rows = std::min<std::ptrdiff_t>(block, count - i0);
    const double* from = plane + static_cast<std::size_t>(i0) * n_;
    if (rows < block) from = std::copy_n(from, rows * n_, rest.data()) - rows * n_;
    gather(from, n_, parts(samples.data()));
    fftw_execute_dft(forward_.get(), raw(samples.data()), raw(halves.data()));
    if (rows == block) {
      unfold(parts(halves.data()), h, turn_.data(), parts(columns + i0), 2 * stride);
      continue;
    }
    unfold(parts(halves.data()), h, turn_.data(), parts(rest_columns.data()), 2 * block);
    for (int k = 0; k <= h; ++k) {
      std::copy_n(rest_columns.data() + static_cast<std::size_t>(block) * k, rows,
                  columns + k * stride + i0);
    }
  }
}

void Rows::inverse(const Complex* columns, std::size_t stride, int count, double* plane) const {
  const int h = m_ / 2;
  Room& room = room_for(h, count % block, n_);
  ComplexField &samples = room.samples, &halves = room.halves, &rest_columns = room.columns;
  Field& rest = room.rows;
#pragma omp for schedule(static)
  for (int i0 = 0; i0 < count; i0 += block) {
    const std::ptrdiff_t rows = std::min<std::ptrdiff_t>(block, count - i0);
    double* to = plane + static_cast<std::size_t>(i0) * n_;
    if (rows == block) {
      fold(parts(columns + i0), 2 * stride, h, turn_.data(), parts(halves.data()));
    } else {
      for (int k = 0; k <= h; ++k) {
        std::copy_n(columns + k * stride + i0, rows,
                    rest_columns.data() + static_cast<std::size_t>(block) * k);
      }
      fold(parts(rest_columns.data()), 2 * block, h, turn_.data(), parts(halves.data()));
    }
    fftw_execute_dft(inverse_.get(), raw(halves.data()), raw(samples.data()));
    scatter(parts(samples.data()), n_, rows == block ? to : rest.data());
    if (rows < block) std::copy_n(rest.data(), rows * n_, to);
  }
}

}  // namespace samcontact::fft
