// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of the operators for residual stress due to eigenstrain (plastic strain) in a layered
// box.
#pragma once

#include <functional>

#include "samcontact/operators/convolution/volume_spectrum.hpp"

namespace samcontact::operators {

/// Method of the residual stress: influence coefficients of cuboids, or sweeps over the layers.
enum class ResidualMethod { exact, fast };

struct ResidualSettings {
  ResidualMethod method = ResidualMethod::exact;
  /// Fast: error due to periodic images, relative to the largest stress.
  double image_tol = 1e-3;
  /// Fast: factor of the stress of a Fourier mode, as a function of wavenumbers in 1/m; empty: 1.
  std::function<double(double kx, double ky)> share = {};
  /// Fast: whether the highest wavenumbers are blended with their aliases; otherwise `share` must
  /// be negligible there.
  bool blends = true;
};

class ResidualStress {
 public:
  virtual ~ResidualStress() = default;

  /// Replaces the spectrum of the eigenstrain by the spectrum of the stress [Pa], in all layers.
  virtual void apply(VolumeSpectrum& strain_to_stress) const = 0;

  /// Part of the stress that its spectrum does not contain, from the strain [component][k][i][j]:
  /// opaque data for correct().
  virtual Field far_field(Tensor tensor, const double* strain) const = 0;
  /// Adds the part from correction data to one layer of the stress, [component][i][j].
  virtual void correct(Tensor tensor, const Field& far_field, int layer, double* stress) const = 0;

  /// Memory of the stored data [byte].
  virtual std::size_t bytes() const = 0;
};

}  // namespace samcontact::operators
