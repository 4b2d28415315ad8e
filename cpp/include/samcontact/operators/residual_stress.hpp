// SPDX-License-Identifier: GPL-3.0-or-later
// Residual stress of eigenstrain (plastic strain) in a layered box: the interface of its operators.
#pragma once

#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::operators {

class ResidualStress {
 public:
  virtual ~ResidualStress() = default;

  /// Replaces the eigenstrain's spectrum by that of the stress [Pa], all layers.
  virtual void apply(VolumeSpectrum& strain_to_stress) const = 0;

  /// Adds to the stress [component][k][i][j] what its spectrum does not contain; the strain
  /// likewise.
  virtual void correct(Tensor tensor, const double* strain, double* stress) const = 0;

  /// Memory of what is stored.
  virtual std::size_t bytes() const = 0;
};

}  // namespace samcontact::operators
