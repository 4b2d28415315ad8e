// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic surface of an adhesive contact with its displacement as the unknown: the stiffness, which
// is the inverse of the compliance, on a grid with padding.
#pragma once

#include <cstddef>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::contact {

/// Fields are [i][j] on mx x my cells: the grid and, unless it is periodic, the padding of the
/// convolution. The displacement of the padding is an unknown as well, with zero pressure: the
/// solution is that of free surfaces.
class AdhesiveSurface {
 public:
  /// Throws std::invalid_argument for free faces and if the stiffness is not positive.
  AdhesiveSurface(const Grid& grid, const operators::SurfaceInfluence& influence);

  /// Surface with a spring in series [m/N], under the same resultant.
  AdhesiveSurface with_spring(double compliance) const;
  /// Surface with a uniform displacement in series that carries no pressure, under a prescribed
  /// resultant: the limit of a spring of zero stiffness.
  AdhesiveSurface with_free_approach() const;

  const Grid& grid() const { return grid_; }
  std::size_t size() const { return static_cast<std::size_t>(transform_.mx()) * transform_.my(); }

  /// Whether a uniform pressure causes no displacement (periodic half-spaces): the mean of the
  /// displacement is then zero, and that of the pressure is free.
  bool has_free_mean() const { return has_free_mean_; }
  /// Whether the displacement contains a free uniform part, and the mean displacement due to a unit
  /// mean pressure without this part [m/Pa].
  bool has_free_approach() const { return has_free_approach_; }
  double uniform_compliance() const { return uniform_compliance_; }
  /// u_z of a cell due to a unit pressure on it [m/Pa].
  double self_influence() const { return self_influence_; }

  /// Displacement [m] due to a pressure [Pa]; `work` is scratch that the caller keeps.
  void displace(const Field& pressure, Field& displacement, ComplexField& work) const;
  /// Pressure [Pa] that causes a displacement [m].
  void press(const Field& displacement, Field& pressure, ComplexField& work) const;
  /// Approximate displacement due to a pressure, which in periodic surfaces is smaller in long
  /// waves: preconditioner of the descent.
  void precondition(const Field& pressure, Field& displacement, ComplexField& work) const;

  /// Field over the grid from a padded field, and the reverse with zeros in the padding.
  Field over_grid(const Field& padded) const;
  Field padded(const Field& over_grid) const;

 private:
  /// Finds the stiffness and the preconditioner. Throws std::invalid_argument unless the stiffness
  /// is positive.
  void invert();
  std::size_t row(int i) const { return static_cast<std::size_t>(i) * transform_.my(); }

  Grid grid_;
  fft::PeriodicTransform transform_;
  Field compliance_, stiffness_, preconditioner_;  // real quarter spectra
  bool has_free_mean_ = false, has_free_approach_ = false;
  double uniform_compliance_ = 0.0;
  double self_influence_;
};

}  // namespace samcontact::contact
