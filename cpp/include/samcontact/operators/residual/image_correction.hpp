// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of the periodic images from a residual stress that was computed with a periodic operator.
//
// Inside the box the field of all images is smooth: the nearest is half a period away. It is
// therefore computed from the polynomial moments of the eigenstrain on a few coarse cells of each
// layer of the body, through influence coefficients summed over the lattice of images, and
// interpolated by polynomials. The error decreases exponentially with the number of coarse cells.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/base/stack.hpp"
#include "samcontact/operators/residual/layer_residual_stress.hpp"

namespace samcontact::operators {

class ImageCorrection : public Images {
 public:
  /// transform: defines the period, at least twice the box less one cell, and the stored cells;
  /// grid: the whole box. tol: allowed error, relative to the largest stress.
  ImageCorrection(const Grid& grid, const VolumeTransform& transform, const Stack& body,
                  double tol);

  /// Stress on the coarse cells.
  Field stress(Tensor tensor, const double* strain) const override;
  void subtract(Tensor tensor, const Field& images, int layer, double* stress) const override;

  std::size_t bytes() const override { return influence_.size() * sizeof(double); }

 private:
  /// Coarse cells along one axis and the polynomials through them.
  struct Axis {
    int fine = 0, coarse = 0;  // fine: the stored cells
    double cell = 0.0;         // size of a coarse cell
    /// [coarse][fine]: weights that give the coarse cells the moments of the fine cells, for
    /// components that are even and odd in a mirror; without a mirror both are equal.
    Field moments[2];
    /// [coarse][fine], likewise: on the mirror plane odd components vanish.
    Field interpolants[2];
  };
  /// means: polynomials have the given means over the coarse cells, and their means over the fine
  /// cells are taken; otherwise values at the centres are used.
  static Axis make_axis(int fine, double d, double extent, int coarse, int order, bool mirrored,
                        bool means);

  /// Axis over adjacent layers.
  static Axis stacked(const std::vector<Axis>& layers);
  /// Also builds the axis along z.
  void build_layers(const Grid& grid, const Stack& body, double tol);
  Field coarse_strain(Tensor tensor, const double* strain) const;
  Field coarse_stress(const Field& strain) const;

  double period_x_, period_y_;
  Axis x_, y_, z_;
  Field influence_;  // [z field][z source][y offset][x offset][in][out, padded]
};

}  // namespace samcontact::operators
