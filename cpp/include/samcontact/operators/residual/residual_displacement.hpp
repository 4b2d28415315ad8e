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
  /// The grid's layers start at the surface. The displacement does not depend on Young's modulus.
  /// shallower: the same of fewer layers, which are taken from it; null: none.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, double nu, Axis axis,
                       Tensor tensor, const ResidualDisplacement* shallower);

  /// The same from tables of the first layers under the full tensor, [component][j][i] [m], on the
  /// offsets of KernelOffsets; those below do nothing.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, Axis axis,
                       const std::function<Field(int layer)>& tables, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower = nullptr);

  /// displacement [i][j] [m] of the eigenstrain whose spectrum is given, which stays: each axis
  /// takes an inverse transform more.
  void apply(const VolumeSpectrum& strain, double* displacement) const;

  int layers() const { return nz_; }
  std::size_t bytes() const { return spectra_.size() * sizeof(double); }

 private:
  ResidualDisplacement(const VolumeTransform& transform, Axis axis, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower);
  /// Puts the table of a component on one layer, [j][i] on the quarter plane, into its place.
  void store(const fft::ParitySpectrum& spectrum, int component, int layer, double* quarter);

  const VolumeTransform* transform_;
  Axis axis_;
  int nz_, first_;  // layers, and which is the first that is not taken from another
  Tensor tensor_;
  Field spectra_;  // [ky][component][layer][kx <= mx/2]
};

}  // namespace samcontact::operators
