// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of a cell and all its images on a periodic surface at the nodes of a coarse lattice.
#pragma once

#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Thread-safe. Tables are [component][j][i] on nodes 0 to half of a period.
class RepeatedCells {
 public:
  /// cells: a grid with both periods, even multiples of the spacing `step` of nodes.
  RepeatedCells(SharedMedium medium, const Grid& cells, int step);

  /// Nodes of one period.
  const Grid& nodes() const { return nodes_; }
  /// If all cells act, the mean over all cells is known: the mean over the nodes is set to it.
  Field stress(Traction traction, double z, Tensor tensor) const;
  Field residual_displacement(Axis axis, int layer) const;

 private:
  Field sum(const PeriodicSums::Make& make) const;
  /// Offsets of the first nodes, in cells.
  CellOffsets offsets(int nx, int ny) const;

  SharedMedium medium_;
  Grid cells_, nodes_;
  int step_;
  PeriodicSums sums_;
};

/// Adds a table [j][i] of offsets 0..size-1, and its images, to a table of offsets 0 to half of a
/// period.
void add_folded(const double* table, int size, kernels::Parity parity, const KernelOffsets& offsets,
                double* to);

/// Sum of an even table over all offsets, including negative ones; of a table of half a period,
/// over one period.
double total(const double* table, int nx, int ny, bool half_of_period);

}  // namespace samcontact::operators
