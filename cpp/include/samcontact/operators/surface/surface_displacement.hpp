// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement due to pressure, friction and frictional heat: a discrete convolution with
// exact coefficients (DC-FFT, Liu, Wang & Liu 2000, doi:10.1016/S0043-1648(00)00427-0).
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::operators {

/// What an iteration of contact needs of the displacement that closes the gap: a linear operator,
/// symmetric.
class NormalDisplacement {
 public:
  virtual ~NormalDisplacement() = default;

  /// displacement [m] of pressure [Pa], both [i][j]; may be the same array. `work` is scratch that
  /// the caller keeps from call to call.
  virtual void apply(const double* pressure, double* displacement, ComplexField& work) const = 0;
  /// u_z of a cell under its own unit pressure, without heat [m/Pa].
  virtual double self_influence() const = 0;
  /// Operations of one application, in the unit of fft::filter_cost.
  virtual double cost() const = 0;

 protected:
  NormalDisplacement() = default;
  NormalDisplacement(const NormalDisplacement&) = default;
  NormalDisplacement(NormalDisplacement&&) = default;
  NormalDisplacement& operator=(const NormalDisplacement&) = default;
  NormalDisplacement& operator=(NormalDisplacement&&) = default;
};

/// Displacement of pressure and all that goes with it: even_ of the part of the influence that is
/// even, rest_ of what is not (friction between dissimilar bodies, moving heat).
class SurfaceDisplacement : public NormalDisplacement {
 public:
  SurfaceDisplacement(const Grid& grid, const SurfaceInfluence& influence);

  /// Of the even part.
  void apply(const double* pressure, double* displacement, ComplexField& work) const override;
  /// The same for the rest.
  void apply_rest(const double* pressure, double* displacement, ComplexField& work) const;

  bool has_rest() const { return !rest_.empty(); }
  double self_influence() const override { return self_influence_; }
  double cost() const override { return convolution_.cost(); }

 private:
  SurfaceConvolution convolution_;
  std::vector<ParityKernel> even_, rest_;  // spectra
  double self_influence_;
};

/// Displacement of one body along an axis [i][j] [m] due to tractions [i][j], their shear
/// multiplied by shear_sign, and along z due to the heat that goes with the pressure; kernels built
/// for this one use.
Field surface_displacement(const Grid& grid, const Medium& medium, const Heating& heating,
                           const Tractions& tractions, double shear_sign, Axis axis);

}  // namespace samcontact::operators
