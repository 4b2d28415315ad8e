// SPDX-License-Identifier: GPL-3.0-or-later
// Inclusions of a moving body far from the contact: one step of their strain in each increment,
// instead of an iteration together with the contact.
#pragma once

#include <memory>

#include "samcontact/simulation/sources/sources.hpp"
#include "samcontact/simulation/state/state.hpp"
#include "samcontact/simulation/strain/outside_strain.hpp"

namespace samcontact::simulation {

struct FarInclusions {
  std::shared_ptr<const PlasticState> history;  // with the renewed strain
  /// On the box of the strain outside it, before it was renewed.
  std::shared_ptr<const FarEffect> effect;
  Box yielding;  // around far cells that flow, whose strain is not renewed; empty: none
};

/// Box of the grid in which the stress of the tractions of a state changes much if a body moves by
/// a cell; empty without tractions.
Box box_near_tractions(const State& from);

/// Cells with known stress, and surface cells with known displacement.
struct FarReach {
  Box box, surface;
};

/// Reach for several increments of a motion, in which the strain outside the box stays as it is.
/// near: the box that the first of them needs.
FarReach reach_of_motion(const State& from, int body, const Box& near);

/// Effect after one more increment of a motion, on its box at the new place; null if the box does
/// not contain the required cells, or if the strain outside must be renewed.
std::shared_ptr<const FarEffect> kept_effect(const State& from, int body, const Box& required);
OutsideStrain outside_of(const FarEffect& effect);

/// Renews the strain of all inclusions in the grid outside a box: one step from their present
/// strain, with the tractions of the state, which the increment hardly changes. Without mirror
/// planes, and for a body whose cells coincide with those of the grid.
FarInclusions renew_far_inclusions(const State& from, int body, const PlasticState& history,
                                   const FarReach& reach, const Sources& sources);

}  // namespace samcontact::simulation
