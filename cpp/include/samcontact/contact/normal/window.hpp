// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the surface where contact is possible: often a small one.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"

namespace samcontact::contact {

/// The smallest window around the cells with pressure or penetration of the surface; the whole
/// surface if there are none.
Box possible_contact(const Grid& grid, const Field& pressure, const Field& gap);

/// The window with a margin for contact that moves, its sides multiples of 8 so that few different
/// sizes occur, and with `present` in it; the whole surface where a window saves little.
Box with_margin(const Grid& grid, const Box& window, const Box& present);

/// The box of the contact, now and before, its sides multiples of 8 as well. before: shear
/// [2][i][j] of the increment before, or empty.
Box slipping_box(const Grid& grid, const Field& pressure, const Field& before);

}  // namespace samcontact::contact
