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
  OutsideStrain outside;  // effect on the box of the strain outside it, before it was renewed
  Box yielding;           // around far cells that flow, whose strain is not renewed; empty: none
};

/// Box of the grid in which the stress of the tractions of a state changes much if a body moves by
/// a cell; empty without tractions.
Box box_near_tractions(const State& from);

/// Renews the strain of all inclusions in the grid outside a box: one step from their present
/// strain, with the tractions of the state, which the increment hardly changes. Without mirror
/// planes, and for a body whose cells coincide with those of the grid.
FarInclusions renew_far_inclusions(const State& from, int body, const PlasticState& history,
                                   const Box& near, const Sources& sources);

}  // namespace samcontact::simulation
