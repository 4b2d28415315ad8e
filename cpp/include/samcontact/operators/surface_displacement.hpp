// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement due to pressure, friction and frictional heat: a discrete convolution
// with exact coefficients (DC-FFT, Liu, Wang & Liu 2000,
// doi:10.1016/S0043-1648(00)00427-0).
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/surface_influence.hpp"

namespace samcontact::operators {

/// Displacement that closes the gap, of pressure and all that goes with it: even_ of the part of
/// the influence that is even, rest_ of what is not (friction between dissimilar bodies, moving
/// heat).
class SurfaceDisplacement {
 public:
  SurfaceDisplacement(const Grid& grid, const SurfaceInfluence& influence);

  /// displacement [m] of pressure [Pa], both [i][j]; may be the same array. `work` is scratch that
  /// the caller keeps from call to call.
  void apply(const double* pressure, double* displacement, ComplexField& work) const;
  /// The same for the rest.
  void apply_rest(const double* pressure, double* displacement, ComplexField& work) const;

  bool has_rest() const { return !rest_.empty(); }
  /// u_z of a cell under its own unit pressure, without heat [m/Pa].
  double self_influence() const { return self_influence_; }
  /// Operations of one application, in the unit of fft::filter_cost.
  double cost() const { return convolution_.cost(); }

 private:
  SurfaceConvolution convolution_;
  std::vector<ParityKernel> even_, rest_;  // spectra
  double self_influence_;
};

/// Displacement [i][j] [m] of tractions [i][j] [Pa] (a null pointer: none) on one body, kernels
/// built for this one use: `influence` is that of pressure.
Field surface_displacement(const Grid& grid, const SurfaceInfluence& influence,
                           double coupling_compliance, const double* pressure,
                           const double* shear_x, const double* shear_y);

}  // namespace samcontact::operators
