// SPDX-License-Identifier: GPL-3.0-or-later
// What does not change during a simulation: grid, bodies, surfaces and friction.
#pragma once

#include <array>
#include <memory>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/plasticity/body.hpp"
#include "samcontact/simulation/cells/mirror.hpp"
#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/scene/operator_cache.hpp"
#include "samcontact/simulation/scene/past_heat.hpp"
#include "samcontact/simulation/scene/strength.hpp"

namespace samcontact::simulation {

/// Bodies are indexed 0 (upper) and 1 (lower).
class Scene {
 public:
  /// reach: how far beyond the grid plastic strain acts along x [cells].
  Scene(const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2,
        Field initial_gap, const contact::FrictionLaw& friction, double image_tol,
        const HeatMarch& march, int reach, Reliefs reliefs, const operators::BandSplit& split = {},
        contact::SharedContactLaw contact_law = contact::hard_contact());

  const Grid grid;
  const std::array<plasticity::Body, 2> bodies;
  const Media media;
  const Field initial_gap;
  const contact::SharedContactLaw contact_law;
  const contact::FrictionLaw friction;
  const std::unique_ptr<const contact::PartialSlipContact> partial_slip;  // null in gross sliding
  const HeatMarch march;
  const int reach;
  const operators::BandSplit split;  // of zones
  /// Whether its grid lets zones be.
  bool may_split() const { return operators::can_be_split(grid, split); }
  const Reliefs reliefs;
  const OperatorCache cache;

  Placement placement(const Travel& travel) const;
  /// Index of the body whose cells are those of the grid, or -1 where none remembers.
  int followed() const;
  /// Heights of a body's relief in the grid [i][j]; 0 without one.
  Field relief(int body, const Travel& travel) const;
  /// Of the cells of a body, where it is by then.
  Strength strength(int body, const Travel& travel) const;
  /// Separation of the undeformed bodies [i][j].
  Field gap(const Travel& travel) const;

  /// An empty history of the heat that enters a body as told.
  operators::HeatHistory heat_history(int body, const operators::Heating& heating) const;

  /// The cells of the grid, and the layers in which the stress under a repulsion is seen: as many
  /// as the grid has, or down to one and a half radii of the spots in contact.
  Box volume_below(const Field& repulsion) const;
  /// Throws std::invalid_argument for a grid without volume or a rigid body.
  void require_volume(int body) const;

  /// Mirror planes that gap, gross sliding and grid leave to all fields.
  fft::Symmetry symmetry(const Travel& travel) const;

 private:
  fft::Symmetry symmetry_of_worn(int body, const Travel& travel) const;

  fft::Symmetry symmetry_;
};

}  // namespace samcontact::simulation
