// SPDX-License-Identifier: GPL-3.0-or-later
// Influence coefficients of a cell that is repeated for ever along x, y or both: the lattice sum of
// those of one cell (docs/theory/periodic.md).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/periodic/lattice_images.hpp"

namespace samcontact::operators {

/// What one cell does: components that are even or odd in x and y.
struct CellInfluence {
  std::vector<kernels::Parity> parities;
  /// On cell offsets 0..nx-1, 0..ny-1: [component][j][i].
  std::function<Field(int nx, int ny)> cell;
  /// The same of a row of cells along y without end: [component][i].
  std::function<Field(int nx)> strip;
  /// Components of the wave (kernels/wave.hpp) of what acts on the cell.
  LatticeImages::Wave wave;
  /// Of a load that is uniform over the surface.
  std::vector<double> uniform;
};

/// The sums on one kind of grid, y periodic, and the shorter period where x is too. Immutable.
class PeriodicTable {
 public:
  /// step: by which the grid is coarser than the cells that act. like: one that may have the same
  /// factors, as of another grid over the same period.
  PeriodicTable(double dx, double dy, const Period& period, int cells_x, int step = 1,
                const PeriodicTable* like = nullptr);

  /// Whether a table along x serves these; else one with x and y exchanged does.
  static bool is_direct(const Grid& grid);
  bool serves(double dx, double dy, const Period& period, int cells_x, int step) const;

  /// The sums on offsets 0..columns()-1, 0..rows()-1: [component][j][i].
  Field sum(const CellInfluence& influence) const;
  int columns() const { return x_.cells; }
  int rows() const { return period_.y / 2 + 1; }

 private:
  /// Of cells as far as y counts, images one by one and the rest.
  Field near_sum(const CellInfluence& influence) const;
  /// Of rows along y: [component][i].
  Field strips(const CellInfluence& influence) const;

  Period period_;
  LatticeAxis x_, near_x_, y_;
  std::unique_ptr<const LatticeImages> cell_images_, strip_images_;
};

}  // namespace samcontact::operators
