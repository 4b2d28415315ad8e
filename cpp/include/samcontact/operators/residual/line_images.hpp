// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of the images of a periodic operator along one direction, for a surface that is periodic
// along the other: farther away than half a period of the latter direction, the field of the images
// is plane strain, due to the mean strain along this direction.
#pragma once

#include "samcontact/operators/residual/layer_residual_stress.hpp"

namespace samcontact::operators {

/// Field in plane strain with the period of the box, minus the field with a period many times as
/// long.
class LineImages : public Images {
 public:
  /// transform: of the grid, periodic in one direction. tol: allowed error, relative to the largest
  /// stress.
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
