// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse cells over a box: what is smooth is summed on them and interpolated.
#pragma once

#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::operators {

/// Linear interpolation along one axis between centres of coarse cells, each `factor` cells long,
/// and centres of cells; extrapolation half a coarse cell at the ends.
struct CoarseAxis {
  int cells, factor;

  int coarse_cells() const { return (cells + factor - 1) / factor; }
  /// The first of the two coarse cells that cell i lies between.
  int lower(int i) const;
  /// Share of coarse cell I in cell i.
  double weight(int i, int I) const;
  /// Cells begin(I) <= i < end(I) hold all that have a share of I.
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
  // Along y: the first of the cells that lie beyond the centre of each coarse cell, and the share
  // of the next coarse cell in each cell.
  std::vector<int> y_begin_;
  Field y_share_;
};

}  // namespace samcontact::operators
