// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement in steady motion of viscoelastic bodies through a contact: an operator that
// is not symmetric but monotone.
#pragma once

#include <vector>

#include "samcontact/operators/surface/creep_kernel.hpp"

namespace samcontact::operators {

class CreepingDisplacement {
 public:
  CreepingDisplacement(const Grid& grid, const std::vector<CreepingBody>& bodies);

  /// displacement [m] that closes the gap, due to pressure [Pa], both [i][j]; both may be one
  /// array. `work` is scratch that the caller keeps from call to call.
  void apply(const double* pressure, double* displacement, ComplexField& work) const {
    convolution_.apply(kernels_, pressure, displacement, work);
  }
  /// Spectra of the inverse of each Fourier mode of the padded grid, with springs of this
  /// compliance [m/Pa] in series.
  std::vector<ParityKernel> inverse(double spring) const;
  void precondition(const std::vector<ParityKernel>& inverse, const double* displacement,
                    double* pressure, ComplexField& work) const {
    convolution_.apply(inverse, displacement, pressure, work);
  }

  /// Elastic displacement of a cell due to a unit pressure on it [m/Pa].
  double self_influence() const { return self_influence_; }
  /// Displacement over pressure of an elastic wave with a wavelength of both sides of the grid
  /// [m/Pa].
  double longest_compliance() const { return longest_compliance_; }
  /// Operations of one application, in units of fft::filter_cost.
  double cost() const { return convolution_.cost(); }

 private:
  double least_at_ends(const Grid& grid) const;
  void prepare_modes(const Grid& grid, double floor);

  SurfaceConvolution convolution_;
  std::vector<ParityKernel> kernels_;  // spectra: even and odd in x
  std::vector<ParityKernel> modes_;    // those of a positive operator, for the inverse
  double self_influence_, longest_compliance_;
};

}  // namespace samcontact::operators
