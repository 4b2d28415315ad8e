// SPDX-License-Identifier: GPL-3.0-or-later
// Between a grid and the one with half as many cells along x and y.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"

namespace samcontact::contact {

/// Cells twice as long; with an odd number of cells the last one sticks out.
Grid coarsened(const Grid& grid);

/// Mean of each coarse cell's part of a field.
Field coarsened(const Grid& grid, const Field& field);

/// Linear interpolation of a coarse field at the cells of `grid`, constant beyond the outermost
/// centres: positive where the coarse field is.
Field refined(const Grid& grid, const Field& coarse);

/// Values of cells without contact become the mean of their neighbours with it, so that an
/// interpolation at the edge has some.
Field filled_outwards(const Grid& grid, const Field& pressure, const Field& values);

}  // namespace samcontact::contact
