// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse cells over a box: smooth fields are summed on them and interpolated.
#pragma once

#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::operators {

/// Linear interpolation along one axis between centres of coarse cells, each `factor` cells long,
/// and centres of cells; extrapolation half a coarse cell at the ends.
struct CoarseAxis {
  int cells, factor;

  int coarse_cells() const { return (cells + factor - 1) / factor; }
  /// First of the two coarse cells between which cell i lies.
  int lower(int i) const;
  /// Weight of coarse cell I in cell i.
  double weight(int i, int I) const;
  /// Cells begin(I) <= i < end(I) are all cells with a weight of I.
  int begin(int I) const;
  int end(int I) const;
};

class CoarseGrid {
 public:
  CoarseGrid(int nx, int ny);

  const CoarseAxis& x() const { return x_; }
  const CoarseAxis& y() const { return y_; }
  std::size_t size() const {
    return static_cast<std::size_t>(x_.coarse_cells()) * y_.coarse_cells();
  }

  /// Sums of a field [i][j] on the coarse cells [I][J]: the transpose of add().
  void gather(const double* field, double* coarse) const;
  /// Adds the interpolation of a coarse field.
  void add(const double* coarse, double* field) const;

 private:
  CoarseAxis x_, y_;
  // Along y: first cell beyond the centre of each coarse cell, and weight of the next coarse cell
  // in each cell.
  std::vector<int> y_begin_;
  Field y_share_;
};

}  // namespace samcontact::operators
