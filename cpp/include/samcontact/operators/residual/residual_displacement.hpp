// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement along an axis due to eigenstrain (plastic strain) in a layered box: one 2-D
// convolution per layer, summed over the layers in wavenumber space.
#pragma once

#include <functional>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::operators {

class ResidualDisplacement {
 public:
  /// The layers of the grid start at the surface. The displacement does not depend on Young's
  /// modulus. shallower: operator of fewer layers from which kernels are copied; null: no such
  /// operator.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, double nu, Axis axis,
                       Tensor tensor, const ResidualDisplacement* shallower);

  /// From tables of the first layers for the full tensor, [component][j][i] [m], on the offsets of
  /// KernelOffsets; layers below have no effect.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, Axis axis,
                       const std::function<Field(int layer)>& tables, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower = nullptr);

  /// displacement [i][j] [m] due to the eigenstrain with the given spectrum, which is not changed:
  /// each axis needs one more inverse transform.
  void apply(const VolumeSpectrum& strain, double* displacement) const;

  int layers() const { return nz_; }
  std::size_t bytes() const { return spectra_.size() * sizeof(double); }

 private:
  ResidualDisplacement(const VolumeTransform& transform, Axis axis, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower);
  /// Stores the table of a component on one layer, [j][i] on the quarter plane.
  void store(const fft::ParitySpectrum& spectrum, int component, int layer, double* quarter);

  const VolumeTransform* transform_;
  Axis axis_;
  int nz_,
      first_;  // number of layers, and the first one that is not taken over from another operator
  Tensor tensor_;
  Field spectra_;  // [ky][component][layer][kx <= mx/2]
};

}  // namespace samcontact::operators
