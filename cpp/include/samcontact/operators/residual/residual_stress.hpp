// SPDX-License-Identifier: GPL-3.0-or-later
// Residual stress of eigenstrain (plastic strain) in a layered box: the interface of its operators.
#pragma once

#include <functional>

#include "samcontact/operators/convolution/volume_spectrum.hpp"

namespace samcontact::operators {

/// How the residual stress is found: from the influence coefficients of cuboids, or by sweeps over
/// the layers.
enum class ResidualMethod { exact, fast };

struct ResidualSettings {
  ResidualMethod method = ResidualMethod::exact;
  /// Fast: error due to periodic images, relative to the largest stress.
  double image_tol = 1e-3;
  /// Fast: what the stress of a wave is multiplied by, wavenumbers in 1/m; none: 1.
  std::function<double(double kx, double ky)> share = {};
  /// Fast: whether the highest waves share their place with their aliases; without, the share must
  /// be next to nothing there.
  bool blends = true;
};

class ResidualStress {
 public:
  virtual ~ResidualStress() = default;

  /// Replaces the eigenstrain's spectrum by that of the stress [Pa], all layers.
  virtual void apply(VolumeSpectrum& strain_to_stress) const = 0;

  /// What the spectrum of the stress does not contain, from the strain [component][k][i][j]: opaque
  /// data for correct().
  virtual Field far_field(Tensor tensor, const double* strain) const = 0;
  /// Adds it to one layer of the stress, [component][i][j].
  virtual void correct(Tensor tensor, const Field& far_field, int layer, double* stress) const = 0;

  /// Memory of what is stored.
  virtual std::size_t bytes() const = 0;
};

}  // namespace samcontact::operators
