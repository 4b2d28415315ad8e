// SPDX-License-Identifier: GPL-3.0-or-later
// Spectral preconditioner of partial slip: inverse of the periodic tangential operator, a symmetric
// 2 x 2 matrix for each wavenumber.
#pragma once

#include <vector>

#include "samcontact/operators/surface/near_tangential.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::contact {

/// On boxes with little padding.
class TangentialPreconditioner {
 public:
  TangentialPreconditioner(const Grid& box, const operators::TangentialInfluence& influence);

  /// z = F^-1 C^-1(k) F r, both [2][i][j]; may be the same array. `work` is scratch.
  void apply(const double* r, double* z, ComplexField& work) const {
    convolution_.apply(inverse_, 2, r, 2, z, work);
  }
  double cost() const { return 2 * convolution_.cost(); }

 private:
  operators::SurfaceConvolution convolution_;
  std::vector<operators::MatrixKernel> inverse_;
};

/// Exact and approximate operator C of a box, and its preconditioner.
struct ShearOperators {
  operators::TangentialDisplacement displacement;
  operators::NearTangential near;
  TangentialPreconditioner preconditioner;

  ShearOperators(const Grid& box, const operators::TangentialInfluence& influence)
      : displacement(box, influence), near(box, influence), preconditioner(box, influence) {}
};

}  // namespace samcontact::contact
