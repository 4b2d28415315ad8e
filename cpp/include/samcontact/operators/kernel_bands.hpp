// SPDX-License-Identifier: GPL-3.0-or-later
// The operators of a medium as a sum of three: one of short range on the cells, one of middle range
// on nodes a few cells apart, and the smooth rest on a coarse lattice. Each is a medium itself.
#pragma once

#include <array>

#include "samcontact/operators/band_split.hpp"
#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

/// The media of the bands of a medium, near, middle and far, on lattices of their nodes: those of
/// near and middle ones are periodic. cells: what nodes stand for, a grid without a period;
/// NodeSpread spreads from them to nodes and gathers. Of heat they know the stress, of one heating.
std::array<SharedMedium, 3> bands_of(const SharedMedium& medium, const Grid& cells,
                                     const BandSplit& split = {});

}  // namespace samcontact::operators
