// SPDX-License-Identifier: GPL-3.0-or-later
// What a cell and all its images on a surface that repeats itself do at the nodes of a coarse
// lattice.
#pragma once

#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Thread-safe. Tables are [component][j][i] on nodes 0 to half of a period.
class RepeatedCells {
 public:
  /// cells: a grid with both periods, even multiples of the `step` of nodes.
  RepeatedCells(SharedMedium medium, const Grid& cells, int step);

  /// The nodes of one period.
  const Grid& nodes() const { return nodes_; }
  /// Where all cells act, the mean over all cells is known: the mean of the nodes is put there.
  Field stress(Traction traction, double z, Tensor tensor) const;
  Field residual_displacement(Axis axis, int layer) const;

 private:
  Field sum(const PeriodicSums::Make& make) const;
  /// The first nodes, in cells.
  CellOffsets offsets(int nx, int ny) const;

  SharedMedium medium_;
  Grid cells_, nodes_;
  int step_;
  PeriodicSums sums_;
};

/// Adds a table [j][i] of offsets 0..size-1, and its images, to one of offsets 0 to half of a
/// period.
void add_folded(const double* table, int size, kernels::Parity parity, const KernelOffsets& offsets,
                double* to);

/// The sum of such a table over all offsets, negative ones too, of one that is even; of half of a
/// period, over a period.
double total(const double* table, int nx, int ny, bool half_of_period);

}  // namespace samcontact::operators
