// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement due to the part of the track of a contact that has left the grid.
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// For each decay: sums over n >= 0 of exp(-decay n) K(offsets.nx + n, j), by row j < offsets.ny
/// [m/Pa], with the displacement K along an axis due to a unit traction at whole cells along x; the
/// grid is not periodic along x. A decay may be infinite. The track is divided into panels, each
/// twice as long as the one before, in which K is interpolated.
std::vector<Field> track_sums(const Medium& medium, Traction kind, Axis axis, const Grid& grid,
                              const KernelOffsets& offsets, const std::vector<double>& decays);

}  // namespace samcontact::operators
