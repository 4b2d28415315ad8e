// SPDX-License-Identifier: GPL-3.0-or-later
// A cheap, nearly exact normal surface displacement on a box of cells: a periodic convolution with
// little padding, and the error of the periodicity, which is smooth, on a coarse grid.
#pragma once

#include <functional>
#include <memory>

#include "samcontact/base/aligned.hpp"
#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/operators/surface/coarse_grid.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::operators {

/// For lines along x and rows along y of a box: periods longer than it by an eighth at least, or
/// that of the surface where it is not longer.
int short_period_x(const Grid& box);
int short_period_y(const Grid& box);

/// Whether a box is too short for anything but full padding: its coarse grid would be as fine.
bool padded_in_full(int nx, int ny);
/// Whether a period of so many points is one of the surface, or longer than any distance.
bool is_exact_period(int size, int cells, int period);

/// Real quarter spectrum [ky][kx] of a displacement due to pressure on a periodic grid, at the
/// distance of the nearest image. influence: SurfaceInfluence::even or elastic.
Field periodic_spectrum(const fft::PeriodicTransform& transform, const Grid& box,
                        const std::function<Field(const CellOffsets&)>& influence);

/// K~ p on nx x ny cells, close to the operator of SurfaceDisplacement for pressure on these cells.
/// The periodic grid is longer than the box by an eighth, so that cells interact across its seam
/// only where |x| exceeds the period minus the box; there the smooth difference of exact and
/// periodic kernel is summed on coarse cells. Small boxes are padded in full instead: exact.
class NearDisplacement {
 public:
  /// Of the even part of the influence. box: as a grid of its own.
  NearDisplacement(const Grid& box, const SurfaceInfluence& influence);

  int nx() const { return transform_.nx(); }
  int ny() const { return transform_.ny(); }

  /// Whether padding is full, so that nothing but rounding is missed.
  bool is_exact() const { return !far_transform_; }

  /// Periodic part: the spectrum of periodic_spectrum() for the short periods, or the full ones.
  const Field& spectrum() const { return near_; }

  /// displacement [m] of pressure [Pa], both [i][j], different arrays; `work` is scratch that the
  /// caller keeps from call to call.
  void apply(const double* pressure, double* displacement, ComplexField& work) const;

  /// Operations of one application, in the unit of fft::filter_cost.
  double cost() const;

 private:
  fft::PeriodicTransform transform_;
  Field near_;
  CoarseGrid coarse_;
  std::unique_ptr<fft::PeriodicTransform> far_transform_;  // null where padding is full
  Field far_;
};

}  // namespace samcontact::operators
