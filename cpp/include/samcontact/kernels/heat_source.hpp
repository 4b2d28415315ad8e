// SPDX-License-Identifier: GPL-3.0-or-later
// Rectangle of uniform heat flux on a half-space, stationary or moving, with its heating time, and
// the points of a table of its influence.
#pragma once

#include <vector>

namespace samcontact::kernels {

/// |x| <= a, |y| <= b, in one unit of length; x and y are fixed to the source.
struct HeatSource {
  double a = 0.0, b = 0.0;
  /// kappa t [length^2]: diffusivity times the time since the source was switched on; infinity:
  /// steady state.
  double heated = 0.0;
  /// V / kappa [1/length]: velocity of the body relative to the source, over the diffusivity.
  double speed_x = 0.0, speed_y = 0.0;
  /// Distances at which the source, which is not steady, is repeated along x and y [length]; it
  /// does not move along these directions. 0: a single source.
  double period_x = 0.0, period_y = 0.0;

  bool is_steady() const;
  bool is_moving() const { return speed_x != 0 || speed_y != 0; }
  double speed() const;
};

/// Tables are over all pairs (x[i], y[j]), field point minus centre of the source, stored [i][j].
/// Both are strictly ascending and not empty.
struct HeatPoints {
  std::vector<double> x, y;
};

/// Whether the heating time is negligible; also keeps 1/(kappa t)^(3/2) finite.
bool nothing_yet(const HeatSource& source);

/// Maximum of speed times extent of the points: the work grows with it.
constexpr double max_heat_path = 1e7;

/// Throws std::invalid_argument unless sizes, points and periods are as stated, `heated` is
/// infinite or in [0, 1e60 a^2], the speed is zero or >= 1e-60/a and within max_heat_path, the
/// depth is finite and >= 0, and tol is in [1e-12, 1e-2].
void check_heat_arguments(const HeatSource& source, const HeatPoints& points, double z, double tol);

}  // namespace samcontact::kernels
