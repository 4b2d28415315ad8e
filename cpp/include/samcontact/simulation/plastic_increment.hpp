// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed point of one increment: contact, stress and radial return for a given guess of the
// plastic strain increment.
#pragma once

#include <array>
#include <stdexcept>
#include <vector>

#include "samcontact/simulation/active_cells.hpp"
#include "samcontact/simulation/heat_of_increment.hpp"
#include "samcontact/simulation/plastic_body.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/source.hpp"

namespace samcontact::simulation {

/// The bodies before they deform, with all that moves with them.
class Undeformed : public Source {
 public:
  explicit Undeformed(Field gap) : gap_(std::move(gap)) {}
  void open(Field& gap) const override;
  void stress(int, const Box&, operators::Tensor, Field&) override {}

 private:
  Field gap_;
};

/// The unknown is the plastic strain increment of the active cells, [cell][component].
class PlasticIncrement {
 public:
  /// from: with the bodies where the increment takes them. scans: by body, null where nothing can
  /// yield.
  PlasticIncrement(const State& from, const Target& target, const Scans& scans,
                   const Settings& settings, Counters& counters);

  struct Result {
    contact::Solution contact;
    double excess = 0.0;     // largest relative yield excess of the stress
    double overshoot = 0.0;  // largest relative yield excess of the trial stress
    /// Euclidean norm, over the cells that flow now or in the guess, of the strain at yield, yield
    /// stress / 3 G.
    double yield_strain_norm = 0.0;
    /// Smallest (yield stress - von Mises)/yield stress of the cells that are not active.
    double headroom = 1.0;
    bool grown = false;  // a box was too small: evaluate again before accepting
  };

  /// A guess to start from: the flow of the last increment, where the bodies go on in the same way;
  /// else empty.
  Field first_guess();

  /// mapped = G(guess). New active cells are appended to both. contact_tol applies to load and
  /// approach.
  Result evaluate(Field& guess, double contact_tol, Field& mapped);

  /// Whether a box had to grow beyond the grid, or zones for what yields outside of them, for what
  /// the last evaluation found: evaluate again. Iterates may flow where the solution does not.
  bool grow_beyond();
  /// The same for zones, once: when the relative change says that pressures have nearly settled.
  /// Growing then does not cost an evaluation.
  bool look_beyond(double residual);

  /// The contact of the last evaluation to a finer tolerance; all else stays.
  void refine_contact(double contact_tol, Result& result);

  bool has_plastic_body() const { return !bodies_.empty(); }

  /// The state after the increment `mapped` of the last evaluation; ends the use of this object.
  State finish(const Field& mapped, const Result& result);

 private:
  fft::Symmetry choose_symmetry() const;
  /// Whether both bodies are made of the same, and have gone and go through the same.
  bool twins() const;
  /// Whether the last increment was a part of the same steady motion; by what part of it.
  double part_of_last_motion() const;
  /// The same of a load or approach that goes on in the same direction, at rest.
  double part_of_last_load() const;
  /// Whether the contact stays the same in it.
  bool is_steady() const;
  void set_zones(PlasticBody& body, const Zones& zones, bool split = false);
  /// In one box, which is stored.
  void set_box(PlasticBody& body, const Box& box) { set_zones(body, Zones({box})); }
  /// Whether strain may be solved for in small zones.
  bool may_split() const;
  bool is_cold_and_at_rest() const;
  /// Disjoint zones that hold some boxes.
  std::vector<Box> merged_zones(const std::vector<Box>& boxes) const;
  /// Whether that is less work than in one box.
  bool is_worth_splitting(const PlasticBody& body, const std::vector<Box>& boxes) const;
  /// Small zones for a body with a history: those of before; of a body that has moved all history
  /// in the grid, and where it flows steadily.
  std::vector<Box> zones_to_begin_with(const PlasticBody& body) const;
  /// Zones for a body with a history.
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
  void scatter(const Field& guess);
  contact::Solution solve_contact(const Field& gap, double tol);
  /// Of bodies that stick and slip.
  contact::Solution stick_and_slip(const Field& gap, const contact::ContactSettings& settings);
  /// What the shear of the increment starts from, before plastic strain slides the bodies.
  contact::ContactHistory contact_before() const;
  /// Of the rigid motion, where bodies that move on also turn and slide by the difference of their
  /// ways.
  contact::TangentialDrive tangential_drive() const;
  /// Whether bodies alike that may stick are not sheared.
  bool rests() const;
  void remember_slip(State& state) const;
  /// Once, when the first contact tells how hot the bodies are.
  void soften();
  /// A body, in a box and where it already is; by the same contact.
  void soften(PlasticBody& body, const Box& box);
  std::invalid_argument flows_as_a_whole(const PlasticBody& body) const;
  /// Whether a box had to grow for the contact or, at first, for the elastic stress.
  bool fit_boxes(const Field& gap);
  /// Whether a body may touch where its residual displacement is not known.
  bool may_touch_outside(const Field& gap) const;
  /// Grows the boxes whose rim flows, in the grid.
  bool grow_at_rim();
  /// What the box of a body, number b of the inelastic ones, must hold where cells of its rim flow
  /// by more than this; stored.
  Box needed_at_rim(std::size_t b, double negligible) const;
  void return_map(const Field& guess, Field& mapped, Result& result);
  void remember_flow(State& state, const Field& mapped) const;
  /// What a body, number b of the inelastic ones, has become.
  void finish(std::size_t b, const Field& mapped, State& state);

  const State& from_;
  const Target& target_;
  const Scans& scans_;
  const Settings& settings_;
  Counters& counters_;
  const Scene& scene_;
  operators::Tractions tractions_;  // [i][j] of the grid
  Undeformed undeformed_;
  HeatOfIncrement heat_;
  const std::array<Source*, 2> sources_;
  fft::Symmetry symmetry_;
  BoxChoice choice_;
  std::vector<PlasticBody> bodies_;  // inelastic ones
  Field gap_;                        // without the elastic displacement, of the last evaluation
  contact::ContactHistory before_;   // of bodies that stick and slip, as the rest
  Field carried_apart_;              // slip that goes with different ways of the bodies
  contact::ShearSolution shear_;     // of the last evaluation
  bool scanned_ = false, looked_ = false;
  std::array<Field, 2> heating_pressure_;  // on each body, of the first contact; empty before
  ActiveCells active_;
};

}  // namespace samcontact::simulation
