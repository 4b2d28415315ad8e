// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse matrices of a grid in which a cell meets its neighbours along x and y only.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"

namespace samcontact::film {

/// Neighbours of the cells of a grid, across its period along y.
class Lattice {
 public:
  explicit Lattice(const Grid& grid)
      : nx_(grid.nx), ny_(grid.ny), wraps_(grid.period.y > 0 && grid.ny > 1) {}

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  std::size_t size() const { return static_cast<std::size_t>(nx_) * ny_; }
  bool wraps() const { return wraps_; }
  /// Number of a cell; -1 outside the grid.
  std::ptrdiff_t at(int i, int j) const {
    if (wraps_) j = in_period(j, ny_);
    if (i < 0 || i >= nx_ || j < 0 || j >= ny_) return -1;
    return static_cast<std::ptrdiff_t>(i) * ny_ + j;
  }

 private:
  int nx_, ny_;
  bool wraps_;
};

/// Matrix with entries for a cell and two neighbours on each side along x and y.
class Star {
 public:
  static constexpr int reach = 2, entries = 9;

  explicit Star(const Lattice& lattice);

  const Lattice& lattice() const { return lattice_; }
  void clear();
  /// Entry of a row for the neighbour at an offset along an axis (0: x, 1: y).
  double& entry(std::size_t row, int axis, int offset) { return values_[slot(axis, offset)][row]; }
  double entry(std::size_t row, int slot) const { return values_[slot][row]; }
  double diagonal(std::size_t row) const { return values_[0][row]; }
  /// Offset of an entry in cells along x and y.
  static std::array<int, 2> offset(int slot);

  /// Adds the product with a field to another field.
  void add_product(const Field& field, Field& sum) const;

 private:
  static int slot(int axis, int offset) {
    if (offset == 0) return 0;
    return 1 + 4 * axis + (offset < 0 ? offset + reach : offset + reach - 1);
  }

  Lattice lattice_;
  std::array<Field, entries> values_;
};

}  // namespace samcontact::film
