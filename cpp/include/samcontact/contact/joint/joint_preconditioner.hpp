// SPDX-License-Identifier: GPL-3.0-or-later
// Spectral preconditioner of pressure and shear together: inverse of the periodic operator, a
// Hermitian 3 x 3 matrix for each wavenumber.
#pragma once

#include <vector>

#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::contact {

/// Preconditioner on a grid with little padding.
class JointPreconditioner {
 public:
  JointPreconditioner(const Grid& grid, const operators::TangentialInfluence& influence);

  /// Tractions (p, s_x, s_y) of a displacement (u_z, u_x, u_y), both [3][i][j]; may be the same
  /// array. `work` is scratch.
  void apply(const double* displacement, double* tractions, ComplexField& work) const {
    convolution_.apply(inverse_, 3, displacement, 3, tractions, work);
  }
  double cost() const { return 3 * convolution_.cost(); }

 private:
  operators::SurfaceConvolution convolution_;
  std::vector<operators::MatrixKernel> inverse_;
};

}  // namespace samcontact::contact
