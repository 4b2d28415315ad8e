// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic subdomains (zones) of the bodies in an increment: the boxes in which plastic strain is
// computed, and their growth.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/softening.hpp"
#include "samcontact/simulation/increment/split_choice.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

/// The zones contain all plastic strain of a body that is solved for: one box or, if split,
/// several.
class ZoneManager {
 public:
  /// All arguments must outlive this object. tractions: of the increment, which change with its
  /// contact.
  ZoneManager(const IncrementTask& task, fft::Symmetry symmetry, const StartGuess& guess,
              const operators::Tractions& tractions, const Sources& sources,
              std::vector<PlasticBody>& bodies, ActiveCells& active);

  /// Creates zones for bodies with a history.
  void begin();
  /// Applies thermal softening to the bodies, once per increment.
  void soften();
  /// Whether zones had to grow for the contact or, initially, for the elastic stress. gap: under
  /// load; empty for prescribed tractions.
  bool fit(const Field& gap);
  /// Grows the zones with plastic flow in their outermost cells, within the grid.
  bool grow_at_rim();
  /// Whether a box had to grow beyond the grid, or zones for cells outside that yield, after the
  /// last evaluation. Intermediate iterates may flow where the solution does not.
  bool grow_beyond();
  /// Check for yield outside the zones, once, when the relative change indicates that the pressure
  /// has nearly converged: growing then does not cost an evaluation.
  bool grow_when_settled(double residual);

  /// Effect of the inclusions of a body far from the contact, if only the strain near the contact
  /// was solved for; else null.
  std::shared_ptr<const FarEffect> far_effect(const PlasticBody& body) const;

 private:
  void set_zones(PlasticBody& body, const Zones& zones, bool split = false);
  /// Uses a single stored box.
  void set_box(PlasticBody& body, const Box& box) { set_zones(body, Zones({box})); }
  void take_up_zones(PlasticBody& body);
  /// Makes the box contain all inclusions of a body.
  void take_up_inclusions(PlasticBody& body);
  /// Makes the box contain the inclusions near the contact only, if the contact moves on without
  /// much change: those far from it are renewed by one step. Returns whether this is so.
  bool take_up_near_inclusions(PlasticBody& body);
  /// Zones around the inclusions of a body at rest, if these require less work than one box.
  /// Returns whether this is so.
  bool take_up_inclusions_in_zones(PlasticBody& body);
  /// Whether a body may have several zones for its plastic flow: inclusions that move are solved
  /// for in one box.
  bool may_split(const PlasticBody& body) const {
    return !body.cells().mixed().is_on() && split_.is_allowed();
  }
  /// Whether zones had to grow for the first elastic stress; there may be none before.
  bool fit_zones(PlasticBody& body);
  bool grow_zones(PlasticBody& body, std::vector<Box> more);
  /// Boxes that the zones must contain in addition because of plastic flow in their outermost
  /// cells.
  std::vector<Box> rims_with_flow(std::size_t b) const;
  /// Grows the zones for cells outside that yield.
  bool grow_for_yield(PlasticBody& body);
  /// Box around the cells in which the bodies may be in contact where the residual displacement of
  /// one of them is not known.
  Box possible_contact_outside(const Field& gap) const;
  /// Stored box that elastic-plastic body number b needs because of plastic flow in the outermost
  /// cells above `negligible`.
  Box needed_at_rim(std::size_t b, double negligible) const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
  BoxChoice choice_;
  SplitChoice split_;
  ThermalSoftening softening_;
  const Sources& sources_;
  std::vector<PlasticBody>& bodies_;
  ActiveCells& active_;
  std::array<std::shared_ptr<const FarEffect>, 2> far_effect_;
  bool scanned_ = false, checked_outside_ = false;
};

}  // namespace samcontact::simulation
