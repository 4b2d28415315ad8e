// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of a cell that is repeated periodically along x, y or both: the lattice
// sum of the coefficients of one cell (docs/theory/periodic.md).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/periodic/lattice_images.hpp"

namespace samcontact::operators {

/// Influence of one cell: components that are even or odd in x and y.
struct CellInfluence {
  std::vector<kernels::Parity> parities;
  /// On cell offsets 0..nx-1, 0..ny-1: [component][j][i].
  std::function<Field(int nx, int ny)> cell;
  /// Influence of an infinite row of cells along y: [component][i].
  std::function<Field(int nx)> strip;
  /// Components of the Fourier mode (kernels/wave.hpp) of the load on the cell.
  LatticeImages::Wave wave;
  /// Influence of a load that is uniform over the surface.
  std::vector<double> uniform;
};

/// Sums on one kind of grid, y periodic with the shorter period if x is periodic too. Immutable.
class PeriodicTable {
 public:
  /// step: factor by which the grid is coarser than the acting cells. like: table that may have
  /// equal factors, such as that of another grid over the same period.
  PeriodicTable(double dx, double dy, const Period& period, int cells_x, int step = 1,
                const PeriodicTable* like = nullptr);

  /// Whether the grid needs a table along x; otherwise one with x and y exchanged.
  static bool is_direct(const Grid& grid);
  bool serves(double dx, double dy, const Period& period, int cells_x, int step) const;

  /// Sums at offsets 0..columns()-1, 0..rows()-1: [component][j][i].
  Field sum(const CellInfluence& influence) const;
  int columns() const { return x_.cells; }
  int rows() const { return period_.y / 2 + 1; }

 private:
  /// Sum over cells up to the distance beyond which y has no influence: near images one by one, and
  /// the remainder.
  Field near_sum(const CellInfluence& influence) const;
  /// Sum over rows along y: [component][i].
  Field strips(const CellInfluence& influence) const;

  Period period_;
  LatticeAxis x_, near_x_, y_;
  std::unique_ptr<const LatticeImages> cell_images_, strip_images_;
};

}  // namespace samcontact::operators
