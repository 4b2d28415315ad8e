// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement due to pressure, friction and frictional heat: discrete convolution with
// exact coefficients (DC-FFT, Liu, Wang & Liu 2000, doi:10.1016/S0043-1648(00)00427-0).
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::operators {

/// Interface of the displacement that closes the gap, for the contact iterations: a symmetric
/// linear operator.
class NormalDisplacement {
 public:
  virtual ~NormalDisplacement() = default;

  /// displacement [m] due to pressure [Pa], both [i][j]; both may be one array. `work` is scratch
  /// that the caller keeps from call to call.
  virtual void apply(const double* pressure, double* displacement, ComplexField& work) const = 0;
  /// u_z of a cell due to a unit pressure on this cell, without heat [m/Pa].
  virtual double self_influence() const = 0;
  /// Operations of one application, in units of fft::filter_cost.
  virtual double cost() const = 0;

 protected:
  NormalDisplacement() = default;
  NormalDisplacement(const NormalDisplacement&) = default;
  NormalDisplacement(NormalDisplacement&&) = default;
  NormalDisplacement& operator=(const NormalDisplacement&) = default;
  NormalDisplacement& operator=(NormalDisplacement&&) = default;
};

/// Displacement due to pressure and the proportional shear and heat: even_ from the even part of
/// the influence and ends_ from free faces, rest_ from the remainder (friction between dissimilar
/// materials, moving heat).
class SurfaceDisplacement : public NormalDisplacement {
 public:
  SurfaceDisplacement(const Grid& grid, const SurfaceInfluence& influence);

  /// Displacement from the even part.
  void apply(const double* pressure, double* displacement, ComplexField& work) const override;
  /// Displacement from the remainder.
  void apply_rest(const double* pressure, double* displacement, ComplexField& work) const;

  /// Effect of free faces, contained in apply(); null: no faces.
  const SharedEndEffects& ends() const { return ends_; }

  /// The influence, with tables of this grid.
  const SurfaceInfluence& influence() const { return influence_; }

  bool has_rest() const { return !rest_.empty(); }
  double self_influence() const override { return self_influence_; }
  double cost() const override { return convolution_.cost() + (ends_ ? ends_->cost() : 0.0); }

 private:
  SurfaceConvolution convolution_;
  SurfaceInfluence influence_;
  std::vector<ParityKernel> even_, rest_;  // spectra
  SharedEndEffects ends_;
  double self_influence_;
};

/// Displacement of one body along an axis [i][j] [m] due to tractions [i][j], their shear
/// multiplied by shear_sign, and along z due to the heat proportional to the pressure; the kernels
/// are built for this call only.
Field surface_displacement(const Grid& grid, const Medium& medium, const Heating& heating,
                           const Tractions& tractions, double shear_sign, Axis axis);

}  // namespace samcontact::operators
