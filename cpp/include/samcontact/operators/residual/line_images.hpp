// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the images away that a periodic operator sees along one direction, where the surface is
// periodic along the other: beyond half a period of the latter all that is left of them is plane
// strain, that of the mean along it.
#pragma once

#include "samcontact/operators/residual/layer_residual_stress.hpp"

namespace samcontact::operators {

/// Plane strain with the box's own period less that with one many times as long.
class LineImages : public Images {
 public:
  /// transform: of the grid, periodic in one direction. tol: the error that is allowed, relative to
  /// the largest stress.
  LineImages(const Grid& grid, const VolumeTransform& transform, const Stack& body, double tol);

  Field stress(Tensor tensor, const double* strain) const override;
  void subtract(Tensor tensor, const Field& images, int layer, double* stress) const override;
  std::size_t bytes() const override { return short_.bytes() + long_.bytes(); }

 private:
  /// Mean along the periodic direction, [component][k][cell].
  Field mean(Tensor tensor, const double* strain) const;

  bool along_x_;              // the images lie along x
  int whole_, nz_, nx_, ny_;  // cells of the periodic direction, layers, stored cells
  bool mirrored_;             // the periodic direction
  Grid line_;
  VolumeTransform short_transform_, long_transform_;
  LayerResidualStress short_, long_;
};

}  // namespace samcontact::operators
