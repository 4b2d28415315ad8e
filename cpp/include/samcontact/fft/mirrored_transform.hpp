// SPDX-License-Identifier: GPL-3.0-or-later
// Two-dimensional transforms of zero-padded planes that are even or odd about the middle of y, and
// optionally of x: a half or a quarter of the plane is stored and transformed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/plan.hpp"
#include "samcontact/fft/rows.hpp"

namespace samcontact::fft {

/// Mirror planes of a field, in the middle of the grid.
enum class Symmetry { none, y, xy };

/// A plane of n cells mirrored in its middle stores the cells from the middle on.
inline int stored_cells(int n, bool mirrored) { return mirrored ? n - n / 2 : n; }

/// The spectrum of a plane about its middle is (-i)^(number of mirrored directions in which it is
/// odd) times the stored spectrum: complex for kx = 0..mx/2 with a mirror in y only, real with
/// both. An even and an odd plane share one real transform along each mirrored direction.
class MirroredTransform {
 public:
  /// nx, ny: cells of the whole plane; mx, my: padded sizes, even.
  MirroredTransform(int nx, int ny, int mx, int my, bool mirror_x);

  int rows() const { return hx_; }
  int columns() const { return hy_; }

  struct Plane {
    double* values;    // [i][j] of the stored cells
    double* spectrum;  // row kx of ky = 0
    bool odd_x, odd_y;
  };
  /// Rows of successive ky are `stride` doubles apart. Unnormalised. Thread-safe; runs on one
  /// thread.
  void forward(std::span<const Plane> planes, std::size_t stride) const;
  /// rows: stored rows i that are transformed back; none: all.
  void inverse(std::span<const Plane> planes, std::size_t stride,
               std::span<const RowRun> rows = {}) const;

 private:
  static constexpr int block = 8;

  /// Mirror along one direction: n cells padded to m.
  struct Mirror {
    Mirror(int n, int m);
    /// Sum of an even and an odd row as a whole row, from the stored cells of each; null: no such
    /// row.
    void join(const double* even, const double* odd, double* row) const;
    /// The first `count` stored cells of each.
    void divide(const double* row, int count, double* even, double* odd) const;
    int stored, m;
    bool shifted;      // the middle lies between two cells
    Field cos_, sin_;  // of k pi / m, k <= m/2
  };
  static std::vector<std::array<int, 2>> pairs(std::span<const Plane> planes, bool along_x);

  /// Intermediate arrays between rows and columns are [plane][ky][i]: size of a plane.
  std::size_t middle_size() const { return static_cast<std::size_t>(mh_) * hx_; }
  void forward_rows(std::span<const Plane> planes) const;
  void forward_columns(std::span<const Plane> planes, std::size_t stride) const;
  void forward_mirrored_columns(std::span<const Plane> planes, std::size_t stride) const;
  /// end: the number of rows from the first to the last one that is needed.
  void inverse_columns(std::span<const Plane> planes, std::size_t stride, int end) const;
  void inverse_mirrored_columns(std::span<const Plane> planes, std::size_t stride, int end) const;
  void inverse_rows(std::span<const Plane> planes, std::span<const RowRun> runs) const;
  /// A block of rows of an even and an odd plane; -1: no such plane.
  void inverse_rows(std::span<const Plane> planes, int even, int odd, int i0, int rows) const;

  int hx_, hy_, mx_, my_, mh_, mk_;
  bool mirror_x_;
  Mirror x_, y_;
  Plan rows_forward_, rows_inverse_, columns_forward_, columns_inverse_;
};

}  // namespace samcontact::fft
