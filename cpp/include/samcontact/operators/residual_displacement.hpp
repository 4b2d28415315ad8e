// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement due to eigenstrain (plastic strain) in a layered box: one 2-D
// convolution per layer, summed over the layers in wavenumber space.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::operators {

class ResidualDisplacement {
 public:
  /// The grid's layers start at the surface. The displacement does not depend on Young's modulus.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, double nu,
                       Tensor tensor);

  /// displacement [i][j] [m] of the eigenstrain whose spectrum is given.
  void apply(const VolumeSpectrum& strain, double* displacement) const;

  std::size_t bytes() const { return spectra_.size() * sizeof(double); }

 private:
  const VolumeTransform* transform_;
  int nz_;
  Tensor tensor_;
  Field spectra_;  // [ky][component][layer][kx <= mx/2]
};

}  // namespace samcontact::operators
