// SPDX-License-Identifier: GPL-3.0-or-later
// The operators of a medium as a sum of three: one of short range on the cells, one of middle range
// on nodes a few cells apart, and the smooth rest on a coarse lattice. Each is a medium itself.
#pragma once

#include <array>

#include "samcontact/operators/medium/medium.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::operators {

/// One band of a medium, and its thermal stress, of one heating.
struct MediumBand {
  SharedMedium medium;
  SharedThermalStress heat;
};

/// The bands of a medium, near, middle and far, on lattices of their nodes: those of near and
/// middle ones are periodic. cells: what nodes stand for, a grid without a period; NodeSpread
/// spreads from them to nodes and gathers.
std::array<MediumBand, 3> bands_of(const SharedMedium& medium, const Grid& cells,
                                   const BandSplit& split = {});

}  // namespace samcontact::operators
