// SPDX-License-Identifier: GPL-3.0-or-later
// All operators of one body's volume, each built when it is first needed.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/medium/medium.hpp"
#include "samcontact/operators/volume/traction_stress.hpp"

namespace samcontact::operators {

struct VolumeOptions {
  Tensor tensor = Tensor::full;
  /// Mirror planes of all fields; the exact method knows none.
  Symmetry symmetry = Symmetry::none;
  ResidualMethod method = ResidualMethod::exact;
  /// Fast method: error due to periodic images, relative to the largest residual stress.
  double image_tol = 1e-3;
  /// Heat that goes with the pressure; null: none.
  std::shared_ptr<const HeatStress> heat = {};
};

/// Thread-safe; shared by bodies of one medium. Strain and stress have the
/// components of options.tensor, [component][k][i][j] on the cells that the symmetry leaves, and so
/// have tractions and displacement.
class VolumeOperators {
 public:
  /// shallower: the same of fewer layers, whose kernels are taken; null: none.
  VolumeOperators(const Grid& grid, SharedMedium medium, const VolumeOptions& options,
                  std::shared_ptr<const VolumeOperators> shallower = {});

  const Grid& grid() const { return grid_; }
  Tensor tensor() const { return options_.tensor; }
  const VolumeTransform& transform() const { return transform_; }
  VolumeSpectrum make_spectrum() const { return {transform_, grid_.nz, options_.tensor}; }

  const ResidualStress& residual_stress() const;
  const ResidualDisplacement& residual_displacement(Axis axis) const;
  /// Stress of an eigenstrain and of tractions; either pointer may be null. shear_sign multiplies
  /// the shear.
  Field stress(const double* strain, const Tractions* tractions, double shear_sign) const;
  /// The same layer by layer, in any order and several at once: calls use(layer, stress
  /// [component][i][j]) for the first ones. spectrum: that of the eigenstrain on entry, zero
  /// without one; destroyed. It may have fewer layers than the grid where the residual stress has
  /// no far field. rows: of a layer, those that are asked for, as VolumeTransform::inverse has
  /// them.
  using Rows = std::function<std::span<const fft::RowRun>(int layer)>;
  void for_each_layer(VolumeSpectrum& spectrum, const double* strain, const Tractions* tractions,
                      double shear_sign,
                      const std::function<void(int layer, const double* stress)>& use,
                      int layers = std::numeric_limits<int>::max(), const Rows& rows = {}) const;

  /// Memory of the kernels built so far.
  std::size_t bytes() const;

 private:
  Grid grid_;
  SharedMedium medium_;
  VolumeOptions options_;
  VolumeTransform transform_;
  /// Under the mutex: lets go of what is shallower when all kernels are there.
  void release_shallower() const;

  mutable std::mutex mutex_;
  mutable std::shared_ptr<const VolumeOperators> shallower_;
  TractionStress traction_stress_;
  mutable std::unique_ptr<ResidualStress> residual_stress_;
  mutable std::array<std::unique_ptr<ResidualDisplacement>, 3> residual_displacement_;  // by axis
};

}  // namespace samcontact::operators
