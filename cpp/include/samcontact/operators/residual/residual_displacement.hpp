// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement along an axis due to eigenstrain (plastic strain) in a layered box: one 2-D
// convolution per layer, summed over the layers in wavenumber space.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::operators {

/// The kernels of a layer are built when it has strain for the first time. Thread-safe.
class ResidualDisplacement {
 public:
  /// The layers of the grid start at the surface. The displacement does not depend on Young's
  /// modulus. shallower: operator of fewer layers whose kernels are shared; null: no such operator.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, double nu, Axis axis,
                       Tensor tensor, const ResidualDisplacement* shallower);

  /// From tables of the first layers for the full tensor, [component][j][i] [m], on the offsets of
  /// KernelOffsets; layers below have no effect.
  ResidualDisplacement(const Grid& grid, const VolumeTransform& transform, Axis axis,
                       std::function<Field(int layer)> tables, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower = nullptr);

  /// displacement [i][j] [m] due to the eigenstrain with the given spectrum, which is not changed:
  /// each axis needs one more inverse transform.
  void apply(const VolumeSpectrum& strain, double* displacement) const;
  /// Builds the kernels of all layers.
  void build_all() const;

  int layers() const { return static_cast<int>(kernels_.size()); }
  std::size_t bytes() const;

 private:
  /// Builds the kernels of layers first..last-1.
  using Build = std::function<void(int first, int last)>;

  ResidualDisplacement(const VolumeTransform& transform, Axis axis, int layers, Tensor tensor,
                       const ResidualDisplacement* shallower);
  /// Builds the missing kernels of layers that are used.
  void prepare(const std::vector<char>& used) const;
  void build(const Grid& grid, double nu, int first, int last) const;
  void build(const KernelOffsets& offsets, const std::function<Field(int layer)>& tables, int first,
             int last) const;
  /// Stores the table of a component on one layer, [j][i] on the quarter plane.
  void store(const fft::ParitySpectrum& spectrum, int component, double* quarter,
             Field& kernel) const;

  const VolumeTransform* transform_;
  Axis axis_;
  Tensor tensor_;
  Build build_;
  mutable std::mutex mutex_;
  /// By layer, [ky][component][kx <= mx/2]; null: not built.
  mutable std::vector<std::shared_ptr<const Field>> kernels_;
};

}  // namespace samcontact::operators
