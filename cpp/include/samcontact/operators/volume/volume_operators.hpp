// SPDX-License-Identifier: GPL-3.0-or-later
// All volume operators of one body, each built on first use.
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

/// Numbers of offsets along x and y at which cells of a box act on each other: tractions on
/// stressed cells, and strained cells on the surface.
struct Reach {
  int x = std::numeric_limits<int>::max(), y = std::numeric_limits<int>::max();

  bool operator==(const Reach&) const = default;
};

struct VolumeOptions {
  Tensor tensor = Tensor::full;
  /// Mirror planes of all fields; not supported by the exact method.
  Symmetry symmetry = Symmetry::none;
  ResidualMethod method = ResidualMethod::exact;
  /// Fast method: error due to periodic images, relative to the largest residual stress.
  double image_tol = 1e-3;
  /// Heat proportional to the pressure; null: no heat.
  std::shared_ptr<const HeatStress> heat = {};
  /// Offsets beyond have no coefficients; the residual stress does not depend on it.
  Reach reach = {};
};

/// Thread-safe; shared by bodies of one medium. Strain and stress have the components of
/// options.tensor, [component][k][i][j] on the cells stored for the symmetry; tractions and
/// displacement likewise.
class VolumeOperators {
 public:
  /// shallower: operators of fewer layers from which kernels are copied; null: no such operators.
  VolumeOperators(const Grid& grid, SharedMedium medium, const VolumeOptions& options,
                  std::shared_ptr<const VolumeOperators> shallower = {});

  const Grid& grid() const { return grid_; }
  Tensor tensor() const { return options_.tensor; }
  const VolumeTransform& transform() const { return transform_; }
  VolumeSpectrum make_spectrum() const { return {transform_, grid_.nz, options_.tensor}; }

  const ResidualStress& residual_stress() const;
  const ResidualDisplacement& residual_displacement(Axis axis) const;
  /// Stress due to an eigenstrain and to tractions [Pa]; either pointer may be null. shear_sign
  /// multiplies the shear.
  Field stress(const double* strain, const Tractions* tractions, double shear_sign) const;
  /// Stress layer by layer, in any order and from several threads: calls use(layer, stress
  /// [component][i][j]) for the first layers. spectrum: that of the eigenstrain on entry, zero
  /// without one; destroyed. It may have fewer layers than the grid if the residual stress has no
  /// far field. rows: the required rows of a layer, as in VolumeTransform::inverse. first: layers
  /// above it are left out.
  using Rows = std::function<std::span<const fft::RowRun>(int layer)>;
  void for_each_layer(VolumeSpectrum& spectrum, const double* strain, const Tractions* tractions,
                      double shear_sign,
                      const std::function<void(int layer, const double* stress)>& use,
                      int layers = std::numeric_limits<int>::max(), const Rows& rows = {},
                      int first = 0) const;

  /// Memory of the kernels built so far [byte].
  std::size_t bytes() const;

 private:
  Grid grid_;
  SharedMedium medium_;
  VolumeOptions options_;
  VolumeTransform transform_;
  /// Releases the shallower operators once all kernels exist; the mutex must be held.
  void release_shallower() const;

  mutable std::mutex mutex_;
  mutable std::shared_ptr<const VolumeOperators> shallower_;
  TractionStress traction_stress_;
  mutable std::unique_ptr<ResidualStress> residual_stress_;
  mutable std::array<std::unique_ptr<ResidualDisplacement>, 3> residual_displacement_;  // by axis
};

}  // namespace samcontact::operators
