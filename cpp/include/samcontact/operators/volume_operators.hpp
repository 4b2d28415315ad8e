// SPDX-License-Identifier: GPL-3.0-or-later
// All operators of one body's volume, each built when it is first needed.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/residual_displacement.hpp"
#include "samcontact/operators/residual_stress.hpp"
#include "samcontact/operators/traction_stress.hpp"

namespace samcontact::operators {

/// Tractions on a surface [i][j] [Pa] in the body's own frame; empty arrays mean none.
struct Tractions {
  Field pressure, shear_x, shear_y;
};

/// How the residual stress is found: from the influence coefficients of cuboids, or by sweeps over
/// the layers.
enum class ResidualMethod { exact, fast };

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

/// Thread-safe; shared by bodies with equal elastic constants. Strain and stress have the
/// components of options.tensor, [component][k][i][j] on the cells that the symmetry leaves, and so
/// have tractions and displacement.
class VolumeOperators {
 public:
  VolumeOperators(const Grid& grid, const Elastic& elastic, const VolumeOptions& options);

  const Grid& grid() const { return grid_; }
  const Elastic& elastic() const { return elastic_; }
  Tensor tensor() const { return options_.tensor; }
  const VolumeTransform& transform() const { return transform_; }
  VolumeSpectrum make_spectrum() const { return {transform_, grid_.nz, options_.tensor}; }

  const ResidualStress& residual_stress() const;
  const ResidualDisplacement& residual_displacement() const;
  /// out += stress of a traction; sign multiplies the shear (the two bodies see opposite shear).
  void add_tractions(const Tractions& tractions, double shear_sign, VolumeSpectrum& out) const;

  /// Stress of an eigenstrain and of tractions; either pointer may be null.
  Field stress(const double* strain, const Tractions* tractions, double shear_sign) const;
  /// The same layer by layer, in any order and several at once: calls use(layer, stress
  /// [component][i][j]). spectrum: that of the eigenstrain on entry, zero without one; destroyed.
  void for_each_layer(VolumeSpectrum& spectrum, const double* strain, const Tractions* tractions,
                      double shear_sign,
                      const std::function<void(int layer, const double* stress)>& use) const;

  /// Memory of the kernels built so far.
  std::size_t bytes() const;

 private:
  Grid grid_;
  Elastic elastic_;
  VolumeOptions options_;
  VolumeTransform transform_;
  mutable std::mutex mutex_;
  mutable TractionStress traction_stress_;
  mutable std::unique_ptr<ResidualStress> residual_stress_;
  mutable std::unique_ptr<ResidualDisplacement> residual_displacement_;
};

}  // namespace samcontact::operators
