// SPDX-License-Identifier: GPL-3.0-or-later
// Constant data of a simulation: grid, bodies, surfaces, contact law and friction.
#pragma once

#include <array>
#include <memory>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/plasticity/body.hpp"
#include "samcontact/simulation/cells/inclusions.hpp"
#include "samcontact/simulation/cells/mirror.hpp"
#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/setup/operator_cache.hpp"
#include "samcontact/simulation/setup/past_heat.hpp"
#include "samcontact/simulation/setup/strength.hpp"

namespace samcontact::simulation {

/// Bodies are indexed 0 (upper) and 1 (lower).
class Setup {
 public:
  /// reach: distance beyond the grid along x within which plastic strain acts [cells].
  Setup(const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2,
        Field initial_gap, contact::FrictionLaw friction, double image_tol,
        const TransientHeating& transient_heating, int reach, Reliefs reliefs,
        const operators::BandSplit& split = {},
        contact::SharedContactLaw contact_law = contact::hard_contact(),
        InclusionsPair inclusions = {});

  const Grid grid;
  const std::array<plasticity::Body, 2> bodies;
  const Media media;
  const Field initial_gap;
  const contact::SharedContactLaw contact_law;
  const contact::FrictionLaw friction;
  const std::shared_ptr<const contact::PartialSlipContact> partial_slip;  // null in full sliding
  const TransientHeating transient_heating;
  const int reach;
  const operators::BandSplit split;  // band decomposition of zones
  /// Whether the grid permits small zones.
  bool may_split() const { return operators::can_be_split(grid, split); }
  const Reliefs reliefs;
  const InclusionsPair inclusions;
  /// Whether a body has strain that follows from its stress: plastic strain, or that of inclusions.
  bool is_strained(int body) const { return bodies[body].is_plastic() || inclusions[body]; }
  const OperatorCache cache;

  /// Contact in partial slip of bodies whose compliances are multiplied by factors.
  std::shared_ptr<const contact::PartialSlipContact> slipping(
      const Compliances& compliances) const {
    return compliances == elastic_compliances ? partial_slip : cache.partial_slip(compliances);
  }

  bool is_viscoelastic() const {
    return bodies[0].is_viscoelastic() || bodies[1].is_viscoelastic();
  }
  /// Whether increments have a duration.
  bool has_time() const { return transient_heating.is_on() || is_viscoelastic(); }

  Placement placement(const Travel& travel) const;
  /// Index of the body whose cells coincide with those of the grid, or -1 if no body has a history.
  int followed() const;
  /// Whether the friction law varies along x with the material of a body.
  bool friction_moves_with(int body) const;
  /// Heights of the relief of a body on the grid [i][j]; 0 without a relief.
  Field relief(int body, const Travel& travel) const;
  /// Yield strength of the cells of a body at its position.
  Strength strength(int body, const Travel& travel) const;
  /// Gap of the undeformed bodies [i][j] [m].
  Field gap(const Travel& travel) const;

  /// Empty history for the heat that enters a body.
  operators::HeatHistory heat_history(int body, const operators::Heating& heating) const;

  /// Cells of the grid and the layers in which the stress under a repulsion is evaluated: the
  /// layers of the grid, or down to one and a half radii of the spots in contact.
  Box volume_below(const Field& repulsion) const;
  /// Throws std::invalid_argument for a grid without layers or a rigid body.
  void require_volume(int body) const;

  /// Throws std::invalid_argument for a body with inclusions that is not supported.
  void require_solvable_inclusions(operators::ResidualMethod method) const;

  /// Mirror planes that gap, full sliding and grid permit for all fields.
  fft::Symmetry symmetry(const Travel& travel) const;

 private:
  fft::Symmetry symmetry_of_worn(int body, const Travel& travel) const;

  fft::Symmetry symmetry_;
};

}  // namespace samcontact::simulation
