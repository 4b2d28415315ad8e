// SPDX-License-Identifier: GPL-3.0-or-later
// What does not change during a simulation, and the operators of its bodies.
#pragma once

#include <array>
#include <list>
#include <memory>
#include <mutex>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/operators/heat/flux_heat.hpp"
#include "samcontact/operators/heat/temperature.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/plasticity/body.hpp"
#include "samcontact/simulation/mirror.hpp"
#include "samcontact/simulation/motion.hpp"
#include "samcontact/simulation/past_heat.hpp"
#include "samcontact/simulation/strength.hpp"

namespace samcontact::simulation {

class ZoneScan;

/// Bodies are indexed 0 (upper) and 1 (lower).
class Scene {
 public:
  /// reach: how far beyond the grid plastic strain acts along x [cells].
  Scene(const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2,
        Field initial_gap, const contact::FrictionLaw& friction, double image_tol,
        const HeatMarch& march, int reach, Reliefs reliefs, const operators::BandSplit& split = {});

  const Grid grid;
  const std::array<plasticity::Body, 2> bodies;
  const std::array<operators::SharedMedium, 2> media;  // one object where they are equal
  const Field initial_gap;
  const contact::FrictionLaw friction;
  const std::unique_ptr<const contact::PartialSlipContact> partial_slip;  // null in gross sliding
  const HeatMarch march;
  const int reach;
  const operators::BandSplit split;  // of zones
  /// Whether its grid lets zones be.
  bool may_split() const { return operators::can_be_split(grid, split); }
  const Reliefs reliefs;

  Placement placement(const Travel& travel) const;
  /// Index of the body whose cells are those of the grid, or -1 where none remembers.
  int followed() const;
  /// Heights of a body's relief in the grid [i][j]; 0 without one.
  Field relief(int body, const Travel& travel) const;
  /// Of the cells of a body, where it is by then.
  Strength strength(int body, const Travel& travel) const;
  /// Separation of the undeformed bodies [i][j].
  Field gap(const Travel& travel) const;

  /// The contact of the scene with this heat; the last one is kept. Thread-safe.
  std::shared_ptr<const contact::ContactSolver> solver(const operators::HeatingPair& heating) const;

  /// Over the window of a box; the last two are kept. Thread-safe.
  std::shared_ptr<const operators::Temperature> temperature(const operators::Heating& heating,
                                                            const Box& box) const;

  /// Tables of a body's heat, null without; the last one of each body is kept. Thread-safe.
  std::shared_ptr<const operators::HeatStress> heat_stress(int body,
                                                           const operators::Heating& heating) const;
  /// An empty history of the heat that enters a body as told.
  operators::HeatHistory heat_history(int body, const operators::Heating& heating) const;

  /// The cells of the grid, and the layers in which the stress under a pressure is seen: as many as
  /// the grid has, or down to one and a half radii of the spots in contact.
  Box volume_below(const Field& pressure) const;
  /// Throws std::invalid_argument for a grid without volume or a rigid body.
  void require_volume(int body) const;

  /// What heat of slip does to a body; that of the last heating is kept. Thread-safe.
  std::shared_ptr<const operators::FluxHeat> flux_heat(int body,
                                                       const operators::Heating& heating) const;

  using Operators = std::shared_ptr<const operators::VolumeOperators>;
  /// Operators of a body on (whole) boxes of this size; bodies of one medium with equal heat share
  /// them. The last few are kept. Thread-safe.
  Operators volume(int body, const Box& box, operators::Tensor tensor,
                   operators::ResidualMethod method, fft::Symmetry symmetry,
                   const operators::Heating& heating) const;

  /// Tables of a body's zones; the last ones with and without heat are kept. Thread-safe.
  std::shared_ptr<const operators::ZoneTables> zone_tables(int body, operators::Tensor tensor,
                                                           const operators::Heating& heating) const;

  /// Where a body yields under such tractions; the last one of each body is kept. Thread-safe.
  std::shared_ptr<const ZoneScan> zone_scan(int body, const operators::Heating& heating) const;

  /// Mirror planes that gap, gross sliding and grid leave to all fields.
  fft::Symmetry symmetry(const Travel& travel) const;

  /// Memory of the operators that are kept.
  std::size_t operator_bytes() const;

 private:
  struct Kept {
    operators::SharedMedium medium;
    Box size;
    operators::Tensor tensor;
    operators::ResidualMethod method;
    fft::Symmetry symmetry;
    operators::Heating heating;
    Operators operators;
  };

  fft::Symmetry symmetry_of_worn(int body, const Travel& travel) const;

  double image_tol_;
  fft::Symmetry symmetry_;
  mutable std::mutex mutex_;
  mutable std::list<Kept> kept_;  // the latest used first
  struct KeptZones {
    int body;  // that made them
    operators::SharedMedium medium;
    operators::Heating heating;  // that is on, else none
    std::shared_ptr<const operators::ZoneTables> tables;
  };
  mutable std::vector<KeptZones> zone_tables_;
  mutable std::array<std::shared_ptr<const ZoneScan>, 2> zone_scans_;
  mutable std::mutex heat_mutex_;
  mutable std::array<std::shared_ptr<const operators::HeatStress>, 2> heat_stress_;
  mutable std::array<std::shared_ptr<const operators::FluxHeat>, 2> flux_heat_;
  mutable std::list<std::shared_ptr<const operators::Temperature>> temperatures_;  // latest first
  mutable operators::HeatingPair solver_heating_;
  mutable std::shared_ptr<const contact::ContactSolver> solver_;
};

}  // namespace samcontact::simulation
