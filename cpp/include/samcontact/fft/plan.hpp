// SPDX-License-Identifier: GPL-3.0-or-later
// FFTW plans: the only access to FFTW. Equal plans are shared, and made one at a time because
// FFTW's planner is not thread-safe (executing a plan is).
#pragma once

#include <fftw3.h>

#include <memory>
#include <type_traits>

#include "samcontact/base/aligned.hpp"

namespace samcontact::fft {

using Plan = std::shared_ptr<std::remove_pointer_t<fftw_plan>>;

inline fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

/// Estimated plans of `count` real lines of length m, stored one after the other: into their half
/// spectra of m/2 + 1 numbers, back, and of one complex line into another (two thirds of the time
/// of an in-place transform; sign FFTW_FORWARD or FFTW_BACKWARD). Made on aligned buffers: run them
/// on aligned buffers.
Plan plan_real_lines(int m, int count);
Plan plan_half_spectra(int m, int count);
Plan plan_line(int m, int sign);
Plan plan_lines_side_by_side(int m, int count, int sign);

/// Called when the library is loaded: FFTW registers its algorithms with the first plan, which
/// takes a tenth of the time of a small solution.
void prepare_planner();

/// Called around a fork, before lock_memory(): plans own memory.
void lock_plans();
void unlock_plans();

/// Smallest even length >= n with prime factors 2, 3, 5 and 7 only: such lengths are fast in FFTW,
/// and even so that a symmetric sequence has a self-mirrored middle.
int good_even_size(int n);

/// Length, at least `min_size`, for a convolution on n cells without wrap-around; or the period of
/// the surface in cells (even), if the period is not longer (period 0: not periodic).
int convolution_size(int n, int period, int min_size = 0);

/// Length >= n for complex lines, at most a fifth longer, for which estimated plans are fast: plans
/// take twice the time per point if 9 divides the length.
int fast_line_size(int n);

/// Counterpart for planes at most a few hundred cells across: at most an eighth longer than
/// good_even_size(n), because other work grows with the plane.
int fast_plane_size(int n);

/// Maximum number of points of rows (class Rows) that are transformed side by side.
constexpr int longest_side_by_side = 256;

/// Counterpart for rows that are transformed side by side, for which factors of 3 and 15 are slow
/// and factors of 9 are not; at most an eighth longer.
int fast_row_size(int n);

}  // namespace samcontact::fft
