// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement due to pressure and, through Coulomb friction, shear: a discrete
// convolution with exact coefficients (DC-FFT, Liu, Wang & Liu 2000,
// doi:10.1016/S0043-1648(00)00427-0).
#pragma once

#include <memory>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/padded_transform.hpp"

namespace samcontact::operators {

/// u_z(p) = normal_compliance/pi Love * p + coupling_compliance/(2 pi) Cerruti * s_x.
class SurfaceDisplacement {
 public:
  /// Compliances [1/Pa] as in base/elastic.hpp, summed over the bodies (the coupling with the sign
  /// of each body's shear). A zero coupling builds no kernel for it.
  SurfaceDisplacement(const Grid& grid, double normal_compliance, double coupling_compliance);

  /// displacement [m] of pressure [Pa], both [i][j]; may be the same array. `work` is scratch that
  /// the caller keeps from call to call.
  void pressure(const double* pressure, double* displacement, ComplexField& work) const;
  /// displacement [m] of shear s_x [Pa]; zero without coupling.
  void shear(const double* shear, double* displacement, ComplexField& work) const;

  bool has_coupling() const { return !coupling_.empty(); }
  /// u_z of a cell under its own unit pressure [m/Pa].
  double self_influence() const { return self_influence_; }
  /// Operations of one application, in the unit of fft::filter_cost.
  double cost() const;

 private:
  fft::PaddedTransform transform_;
  Field normal_;    // real quarter spectrum [ky][kx]
  Field coupling_;  // likewise, odd in x
  double self_influence_;
};

/// Displacement [i][j] [m] of tractions [i][j] [Pa] (a null pointer: none), kernels built for this
/// one use. Compliances of one body.
Field surface_displacement(const Grid& grid, double normal_compliance, double coupling_compliance,
                           const double* pressure, const double* shear_x, const double* shear_y);

}  // namespace samcontact::operators
