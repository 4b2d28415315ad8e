// SPDX-License-Identifier: GPL-3.0-or-later
// Relative displacement of the surfaces in steady rolling of viscoelastic bodies, due to pressure
// and shear.
#pragma once

#include <array>
#include <vector>

#include "samcontact/operators/surface/creep_kernel.hpp"

namespace samcontact::operators {

class CreepingTractions {
 public:
  /// The grid is not periodic along x. Bodies without terms of creep are elastic.
  CreepingTractions(const Grid& grid, const std::array<CreepingBody, 2>& bodies);

  /// Displacement of body 2 less that of body 1 along x and y, and displacement that closes the gap
  /// [3][i][j] [m], due to pressure [i][j] and shear on body 2 [2][i][j] [Pa].
  Field displacement(const Field& pressure, const Field& shear) const;

  const Grid& grid() const { return grid_; }

 private:
  Grid grid_;
  SurfaceConvolution convolution_;
  std::vector<MatrixKernel> kernels_;  // spectra
};

}  // namespace samcontact::operators
