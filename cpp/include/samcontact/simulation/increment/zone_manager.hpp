// SPDX-License-Identifier: GPL-3.0-or-later
// The zones of the bodies in an increment: where plastic strain is solved for, and how they grow.
#pragma once

#include <stdexcept>
#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/softening.hpp"
#include "samcontact/simulation/increment/split_choice.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

/// Zones hold all strain of a body that is solved for, in its one box or, split, in several.
class ZoneManager {
 public:
  /// What it refers to outlives it. tractions: of the increment, which change with its contact.
  ZoneManager(const IncrementTask& task, fft::Symmetry symmetry, const StartGuess& guess,
              const operators::Tractions& tractions, const Sources& sources,
              std::vector<PlasticBody>& bodies, ActiveCells& active);

  /// Zones for bodies with a history.
  void begin();
  /// Softens the bodies, once.
  void soften();
  /// Whether zones had to grow for the contact or, at first, for the elastic stress. gap: under
  /// load; empty where tractions are prescribed.
  bool fit(const Field& gap);
  /// Grows the zones whose rim flows, in the grid.
  bool grow_at_rim();
  /// Whether a box had to grow beyond the grid, or zones for what yields outside of them, for what
  /// the last evaluation found. Iterates may flow where the solution does not.
  bool grow_beyond();
  /// The same for zones, once: when the relative change says that pressures have nearly settled.
  /// Growing then does not cost an evaluation.
  bool look_beyond(double residual);

 private:
  void set_zones(PlasticBody& body, const Zones& zones, bool split = false);
  /// In one box, which is stored.
  void set_box(PlasticBody& body, const Box& box) { set_zones(body, Zones({box})); }
  void take_up_zones(PlasticBody& body);
  /// Whether zones had to grow for the elastic stress that was found first; there may be none
  /// before.
  bool fit_zones(PlasticBody& body);
  bool grow_zones(PlasticBody& body, std::vector<Box> more);
  /// What zones must hold besides themselves where cells of their rims flow.
  std::vector<Box> rims_that_flow(std::size_t b) const;
  /// Grows zones for what yields outside of them.
  bool grow_for_yield(PlasticBody& body);
  /// The box around a body's zones, whole; empty before there are some.
  Box whole_or_none(const PlasticBody& body) const;
  std::invalid_argument flows_as_a_whole(const PlasticBody& body) const;
  /// Whether a body may touch where its residual displacement is not known.
  bool may_touch_outside(const Field& gap) const;
  /// What the box of a body, number b of the inelastic ones, must hold where cells of its rim flow
  /// by more than this; stored.
  Box needed_at_rim(std::size_t b, double negligible) const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
  BoxChoice choice_;
  SplitChoice split_;
  ThermalSoftening softening_;
  const Sources& sources_;
  std::vector<PlasticBody>& bodies_;
  ActiveCells& active_;
  bool scanned_ = false, looked_ = false;
};

}  // namespace samcontact::simulation
