// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement of two bodies due to shear: relative tangential displacement and, for
// dissimilar materials, normal displacement; and tangential displacement due to pressure.
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Coefficients of both bodies: tangential displacement of body 2 relative to body 1, and
/// displacement of both into the bodies along z, due to tractions on body 2 and their opposites on
/// body 1.
class TangentialInfluence {
 public:
  /// layer: tangential displacement per unit shear of an elastic layer between the bodies, which is
  /// thin compared with a cell [m/Pa].
  TangentialInfluence(SharedMedium body1, SharedMedium body2, double layer = 0.0);

  /// Table [j][i] [m/Pa]; its parity is given by compliance_parity().
  Field table(Traction traction, Axis axis, const Grid& grid, const CellOffsets& offsets) const;
  /// Ratio of displacement to shear of a Fourier mode with shear along its wavevector, the smallest
  /// ratio of all directions, which equals the ratio for pressure [m/Pa]; wavenumber > 0 [1/m].
  double wave_compliance(double wavenumber) const {
    return body1_->wave_compliance(wavenumber) + body2_->wave_compliance(wavenumber);
  }

 private:
  SharedMedium body1_, body2_;
  double layer_;
};

/// C: shear to relative tangential displacement. Surface vectors are [component][i][j].
class TangentialDisplacement {
 public:
  /// Exact on a grid, with full padding.
  TangentialDisplacement(const Grid& grid, const TangentialInfluence& influence);

  /// displacement [m] due to shear [Pa], both [2][i][j]; both may be one array. `work` is scratch
  /// that the caller keeps from call to call.
  void apply(const double* shear, double* displacement, ComplexField& work) const;
  /// Displacement along x of a cell due to a unit shear on it [m/Pa].
  double self_influence() const { return self_influence_; }
  /// Displacement of the next cell along x [m/Pa].
  double neighbour_influence() const { return neighbour_influence_; }
  /// Operations of one application, in units of fft::filter_cost.
  double cost() const { return 2 * convolution_.cost(); }

 private:
  SurfaceConvolution convolution_;
  std::vector<MatrixKernel> kernels_;
  double self_influence_, neighbour_influence_;
};

/// The tables of C, untransformed: xx, xy, yx, yy.
std::vector<MatrixKernel> tangential_kernels(const Grid& grid, const TangentialInfluence& influence,
                                             const KernelOffsets& offsets);

/// B and its transpose: normal displacement due to shear, and tangential displacement due to
/// pressure. Zero for identical materials.
class NormalTangentialCoupling {
 public:
  NormalTangentialCoupling(const Grid& grid, const TangentialInfluence& influence);

  bool is_on() const { return !to_normal_.empty(); }
  /// B s [i][j] [m] for shear [2][i][j] [Pa].
  void normal(const double* shear, double* displacement, ComplexField& work) const;
  /// B' p [2][i][j] [m] for pressure [i][j] [Pa].
  void tangential(const double* pressure, double* displacement, ComplexField& work) const;

 private:
  SurfaceConvolution convolution_;
  std::vector<MatrixKernel> to_normal_, to_tangential_;
};

}  // namespace samcontact::operators
