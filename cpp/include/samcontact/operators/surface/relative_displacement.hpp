// SPDX-License-Identifier: GPL-3.0-or-later
// Relative surface displacement of two bodies due to pressure and shear together: all nine
// coefficients.
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::operators {

/// Tables of [[K, B], [B', C]], not transformed, row by row; components are z, x and y.
std::vector<MatrixKernel> relative_kernels(const Grid& grid, const TangentialInfluence& influence,
                                           const KernelOffsets& offsets);

/// [[K, B], [B', C]]: pressure and shear to the displacement that closes the gap and the relative
/// tangential displacement. Surface fields are [3][i][j].
class RelativeDisplacement {
 public:
  /// Exact operator on a grid, with full padding.
  RelativeDisplacement(const Grid& grid, const TangentialInfluence& influence);

  /// Displacement (u_z, u_x, u_y) [m] due to tractions (p, s_x, s_y) [Pa]; may be the same array.
  /// `work` is scratch, which can be reused in further calls.
  void apply(const double* tractions, double* displacement, ComplexField& work) const {
    convolution_.apply(kernels_, 3, tractions, 3, displacement, work);
  }
  /// u_z of a cell due to a unit pressure on it, and u_x due to a unit shear s_x [m/Pa].
  double normal_self_influence() const { return normal_self_influence_; }
  double tangential_self_influence() const { return tangential_self_influence_; }
  /// Operations of one application, in units of fft::filter_cost.
  double cost() const { return 3 * convolution_.cost(); }

 private:
  SurfaceConvolution convolution_;
  std::vector<MatrixKernel> kernels_;
  double normal_self_influence_, tangential_self_influence_;
};

}  // namespace samcontact::operators
