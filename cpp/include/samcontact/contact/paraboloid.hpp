// SPDX-License-Identifier: GPL-3.0-or-later
// Paraboloid that approximates the gap of two bodies, for estimates by Hertz theory.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "samcontact/base/grid.hpp"

namespace samcontact::contact {

struct Paraboloid {
  double larger = 0.0, smaller = 0.0;  // radii of curvature [m]
  double cosine = 1.0;                 // of the angle between x and the plane of the larger radius
  std::array<double, 2> reach{};       // distances along x and y within which the heights are close
                                       // to the paraboloid [m]
};

/// Maximum deviations of heights from a paraboloid.
struct ParaboloidTolerance {
  /// On the grid, divided by the range of the heights.
  double on_grid = 0.0;
  /// At the reach, divided by the height of the paraboloid there. Beyond the grid, the deviation is
  /// assumed to grow like the fourth power of the distance.
  double at_reach = 0.0;
};

/// Convex paraboloid fitted by least squares to heights [i][j] [m] at up to 17 x 17 points. Empty
/// if the heights are infinite or equal, deviate more than the tolerance, or do not curve upwards
/// along both axes.
std::optional<Paraboloid> fitted_paraboloid(std::span<const double> heights, const Grid& grid,
                                            const ParaboloidTolerance& tolerance);

}  // namespace samcontact::contact
