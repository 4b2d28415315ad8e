// SPDX-License-Identifier: GPL-3.0-or-later
// First and last pass of a two-dimensional real transform: rows along y, padded with zeros, into
// columns along x and back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::fft {

/// Consecutive rows of a plane.
struct RowRun {
  int first, count;
};

/// Runs of rows that contain all rows in use; where possible, each run has as many rows as are
/// transformed at once.
std::vector<RowRun> runs_of(std::span<const char> used);

/// Rows of n cells padded to m, which is even. In a parallel region its threads share the rows;
/// outside, one thread does all.
class Rows {
 public:
  Rows(int n, int m);

  /// plane [i][j] of `count` rows into columns [ky][i], ky = 0..m/2, `stride` numbers apart.
  void forward(const double* plane, int count, Complex* columns, std::size_t stride) const;
  void inverse(const Complex* columns, std::size_t stride, int count, double* plane) const;

 private:
  struct Room;
  Room& room_for(std::ptrdiff_t rest) const;
  void forward_side_by_side(const double* plane, Room& room, double* columns,
                            std::ptrdiff_t step) const;
  void inverse_side_by_side(const double* columns, std::ptrdiff_t step, Room& room,
                            double* plane) const;
  void forward_lines(const double* plane, std::ptrdiff_t rows, Room& room, double* columns,
                     std::ptrdiff_t step) const;
  void inverse_lines(const double* columns, std::ptrdiff_t step, std::ptrdiff_t rows, Room& room,
                     double* plane) const;

  int n_, m_;
  bool side_by_side_;
  Plan forward_, inverse_;
  ComplexField turn_;  // exp(-2 pi i k / m), k <= m/4
};

}  // namespace samcontact::fft
