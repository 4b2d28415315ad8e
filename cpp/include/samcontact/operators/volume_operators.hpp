// SPDX-License-Identifier: GPL-3.0-or-later
// All operators of one body's volume, each built when it is first needed.
#pragma once

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

/// Thread-safe; shared by bodies with equal elastic constants.
class VolumeOperators {
 public:
  VolumeOperators(const Grid& grid, const Elastic& elastic);

  const Grid& grid() const { return grid_; }
  const Elastic& elastic() const { return elastic_; }
  const fft::PaddedTransform& transform() const { return transform_; }

  const ResidualStress& residual_stress() const;
  const ResidualDisplacement& residual_displacement() const;
  /// out += stress of a traction; sign multiplies the shear (the two bodies see opposite shear).
  void add_tractions(const Tractions& tractions, double shear_sign, VolumeSpectrum& out) const;

  /// Memory of the kernels built so far.
  std::size_t bytes() const;

 private:
  Grid grid_;
  Elastic elastic_;
  fft::PaddedTransform transform_;
  mutable std::mutex mutex_;
  mutable TractionStress traction_stress_;
  mutable std::unique_ptr<ResidualStress> residual_stress_;
  mutable std::unique_ptr<ResidualDisplacement> residual_displacement_;
};

}  // namespace samcontact::operators
