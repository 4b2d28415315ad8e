// SPDX-License-Identifier: GPL-3.0-or-later
// The operators of a medium as a sum of three: one of short range on the cells, one of middle range
// on nodes a few cells apart, and the smooth rest on a coarse lattice. Each is a medium itself.
#pragma once

#include <array>

#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

enum class Band { near, middle, far };

/// Cells between the nodes of a band.
constexpr int spacing(Band band) { return band == Band::near ? 1 : band == Band::middle ? 2 : 8; }
/// Cells beyond which the near band has no influence.
inline constexpr int near_range = 6;
/// Nodes at the end of the far lattice that must stay empty: there its tables fade out.
inline constexpr int fading_nodes = 6;

/// The media of the bands of a medium, near, middle and far, on lattices of their nodes: those of
/// near and middle ones are periodic. cells: what nodes stand for, a grid without a period;
/// NodeSpread spreads from them to nodes and gathers. Of heat they know the stress, of one heating.
std::array<SharedMedium, 3> bands_of(const SharedMedium& medium, const Grid& cells);

}  // namespace samcontact::operators
