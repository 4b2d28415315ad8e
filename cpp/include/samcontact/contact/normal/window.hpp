// SPDX-License-Identifier: GPL-3.0-or-later
// Candidate contact region: the part of the surface where contact is possible, often small.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"

namespace samcontact::contact {

/// Smallest rectangle around the cells with pressure or interpenetration; the whole surface if
/// there are none.
Box possible_contact(const Grid& grid, const Field& pressure, const Field& gap);

/// Rectangle with a margin for a contact that moves, which also contains `present`; its sides are
/// multiples of 8 so that few different sizes occur. The whole surface if a smaller rectangle saves
/// little.
Box with_margin(const Grid& grid, const Box& window, const Box& present);

/// Rectangle around the present and the previous contact, with sides that are multiples of 8.
/// before: shear [2][i][j] of the previous increment, or empty.
Box slipping_box(const Grid& grid, const Field& pressure, const Field& before);

}  // namespace samcontact::contact
