// SPDX-License-Identifier: GPL-3.0-or-later
// Approximate normal surface displacement on a box of cells at low cost: a periodic convolution
// with little padding, and a correction of the error due to periodicity, which is smooth, on a
// coarse grid.
#pragma once

#include <functional>
#include <memory>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/operators/surface/coarse_grid.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::operators {

/// Periods for lines along x and rows along y of a box: longer than the box by at least an eighth,
/// or the period of the surface if it is not longer.
int short_period_x(const Grid& box);
int short_period_y(const Grid& box);

/// Whether this number of points is the period of the surface, or is longer than any distance.
bool is_exact_period(int size, int cells, int period);

/// Real quarter spectrum [ky][kx] of the displacement due to pressure on a periodic grid, at the
/// distance of the nearest image. influence: SurfaceInfluence::even or elastic.
Field periodic_spectrum(const fft::PeriodicTransform& transform, const Grid& box,
                        const std::function<Field(const CellOffsets&)>& influence);

/// K~ p on nx x ny cells, close to the operator of SurfaceDisplacement for pressure on these cells.
/// The periodic grid is longer than the box by an eighth, so that cells interact across its seam
/// only if |x| exceeds the period minus the box; there the smooth difference of exact and periodic
/// kernel is summed on coarse cells. Small boxes are padded in full instead: exact.
class NearDisplacement {
 public:
  /// Uses the even part of the influence. box: as a grid of its own. ends: effect of free faces on
  /// this box; null: no faces.
  NearDisplacement(const Grid& box, const SurfaceInfluence& influence, SharedEndEffects ends = {});

  int nx() const { return transform_.nx(); }
  int ny() const { return transform_.ny(); }

  /// Whether padding is full, so that the result is exact to rounding.
  bool is_exact() const { return !far_transform_; }

  /// Periodic part: the spectrum of periodic_spectrum() for the short periods, or for full padding.
  const Field& spectrum() const { return near_; }

  /// displacement [m] due to pressure [Pa], both [i][j], different arrays; `work` is scratch that
  /// the caller keeps from call to call.
  void apply(const double* pressure, double* displacement, ComplexField& work) const;

  /// Operations of one application, in units of fft::filter_cost.
  double cost() const;

 private:
  fft::PeriodicTransform transform_;
  Field near_;
  CoarseGrid coarse_;
  std::unique_ptr<fft::PeriodicTransform> far_transform_;  // null with full padding
  Field far_;
  SharedEndEffects ends_;
};

}  // namespace samcontact::operators
