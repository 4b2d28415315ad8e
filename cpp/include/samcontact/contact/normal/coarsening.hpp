// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer between a grid and the grid with half as many cells along x and y.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"

namespace samcontact::contact {

/// Grid of cells twice as long; with an odd number of cells the last coarse cell extends beyond the
/// grid.
Grid coarsened(const Grid& grid);

/// Mean of a field over the part of each coarse cell that lies in the grid.
Field coarsened(const Grid& grid, const Field& field);

/// Linear interpolation of a coarse field at the cells of `grid`, constant beyond the outermost
/// centres: positive where the coarse field is.
Field refined(const Grid& grid, const Field& coarse);

/// Replaces the values of cells out of contact by the mean of their neighbours in contact, for
/// interpolation at the edge of the contact.
Field filled_outwards(const Grid& grid, const Field& pressure, const Field& values);

}  // namespace samcontact::contact
