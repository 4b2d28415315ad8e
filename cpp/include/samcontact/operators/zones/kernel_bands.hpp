// SPDX-License-Identifier: GPL-3.0-or-later
// Decomposition of the operators of a medium into three bands: one of short range on the cells, one
// of middle range on nodes a few cells apart, and the smooth remainder on a coarse lattice. Each
// band is a medium itself.
#pragma once

#include <array>

#include "samcontact/operators/medium/medium.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::operators {

/// One band of a medium, and its thermal stress for one heating.
struct MediumBand {
  SharedMedium medium;
  SharedThermalStress heat;
};

/// Bands of a medium, near, middle and far, on the lattices of their nodes: those of the near and
/// middle nodes are periodic. cells: grid that the nodes represent, not periodic; NodeSpread
/// spreads from its cells to nodes and gathers.
std::array<MediumBand, 3> bands_of(const SharedMedium& medium, const Grid& cells,
                                   const BandSplit& split = {});

}  // namespace samcontact::operators
