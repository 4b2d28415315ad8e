// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle of uniform heat flux on a half-space that it has heated for some time, standing or
// moving, and the points of a table of its influence.
#pragma once

#include <vector>

namespace samcontact::kernels {

/// |x| <= a, |y| <= b, in one unit of length; x and y are fixed to the source.
struct HeatSource {
  double a, b;
  /// kappa t [length^2]: diffusivity times the time since it was switched on; infinity means
  /// steady.
  double heated;
  /// V / kappa [1/length]: velocity of the body relative to the source, over the diffusivity.
  double speed_x, speed_y;

  bool is_steady() const;
  bool is_moving() const { return speed_x != 0 || speed_y != 0; }
  double speed() const;
};

/// Tables are over all pairs (x[i], y[j]), field point minus centre of the source, stored [i][j].
/// Both ascend strictly and are not empty.
struct HeatPoints {
  std::vector<double> x, y;
};

/// Whether the source has only just been switched on; also keeps 1/(kappa t)^(3/2) finite.
bool nothing_yet(const HeatSource& source);

/// Largest speed times extent of the points: the work grows with it.
constexpr double max_heat_way = 1e7;

/// Throws std::invalid_argument unless sizes and points are as stated, `heated` is infinite or in
/// [0, 1e60 a^2], the speed is zero or >= 1e-60/a and within max_heat_way, the depth is finite and
/// >= 0, and tol is in [1e-12, 1e-2].
void check_heat_arguments(const HeatSource& source, const HeatPoints& points, double z, double tol);

}  // namespace samcontact::kernels
