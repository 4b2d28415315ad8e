// SPDX-License-Identifier: GPL-3.0-or-later
// Approximate tangential surface displacement on a box of cells, constructed like NearDisplacement.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/operators/surface/coarse_grid.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::operators {

class NearTangential {
 public:
  NearTangential(const Grid& box, const TangentialInfluence& influence);

  /// displacement [m] due to shear [Pa], both [2][i][j], different arrays; `work` is scratch.
  void apply(const double* shear, double* displacement, ComplexField& work) const;
  /// Operations of one application, in units of fft::filter_cost.
  double cost() const;

 private:
  void add_far_kernels(const Grid& box, const TangentialInfluence& influence);

  SurfaceConvolution near_;
  std::vector<MatrixKernel> kernels_;
  CoarseGrid coarse_;
  std::unique_ptr<SurfaceConvolution> far_;  // null with full padding
  std::vector<MatrixKernel> far_kernels_;
};

}  // namespace samcontact::operators
