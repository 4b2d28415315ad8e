// SPDX-License-Identifier: GPL-3.0-or-later
// The only door to FFTW: plans, shared by all that need the same, made one at a time because FFTW's
// planner is not thread-safe (executing a plan is).
#pragma once

#include <fftw3.h>

#include <memory>
#include <type_traits>

#include "samcontact/base/aligned.hpp"

namespace samcontact::fft {

using Plan = std::shared_ptr<std::remove_pointer_t<fftw_plan>>;

inline fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

/// Plans, estimated, of `count` real lines of length m one after the other into their half spectra
/// of m/2 + 1 numbers, back, and of one complex line into another, which takes two thirds of the
/// time of one in place (sign FFTW_FORWARD or FFTW_BACKWARD). Made on aligned buffers: run them on
/// such.
Plan plan_real_lines(int m, int count);
Plan plan_half_spectra(int m, int count);
Plan plan_line(int m, int sign);
Plan plan_lines_side_by_side(int m, int count, int sign);

/// Around a fork, and before lock_memory(): plans own memory.
void lock_plans();
void unlock_plans();

/// Smallest even length >= n with prime factors 2, 3, 5 and 7 only: lengths FFTW does fast, and
/// even so that a symmetric sequence has a self-mirrored middle.
int good_even_size(int n);

/// Length for a convolution on n cells without wrap-around, at least `least`; where the surface
/// repeats itself after an even number of cells not longer than that (period 0: never).
int convolution_size(int n, int period, int least = 0);

/// A length >= n for complex lines, at most a fifth longer, for which estimated plans are fast:
/// they take twice the time per point when 9 divides the length.
int fast_line_size(int n);

/// The same for planes of at most a few hundred cells across, whose other work grows with them: at
/// most an eighth longer than good_even_size(n).
int fast_plane_size(int n);

/// Rows (class Rows) of at most so many points are transformed side by side.
constexpr int longest_side_by_side = 256;

/// The same for rows: side by side, 9 does no harm, but 3 and 15 do, and they are at most an eighth
/// longer.
int fast_row_size(int n);

}  // namespace samcontact::fft
