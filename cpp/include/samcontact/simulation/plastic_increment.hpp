// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed point of one increment: contact, stress and radial return for a given guess of the
// plastic strain increment.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/active_cells.hpp"
#include "samcontact/simulation/heat_of_increment.hpp"
#include "samcontact/simulation/outside_strain.hpp"
#include "samcontact/simulation/simulation.hpp"

namespace samcontact::simulation {

/// The unknown is the plastic strain increment of the active cells, [cell][component]. Each
/// inelastic body has a box that holds its plastic strain and every cell that may flow; it grows by
/// itself.
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

  /// The contact of the last evaluation to a finer tolerance; all else stays.
  void refine_contact(double contact_tol, Result& result);

  bool has_plastic_body() const { return !bodies_.empty(); }

  /// The state after the increment `mapped` of the last evaluation; ends the use of this object.
  State finish(const Field& mapped, const Result& result);

 private:
  struct Body {
    int index = 0;
    const YieldScan* scan = nullptr;
    std::shared_ptr<const PlasticState> history;  // before the increment; null: none
    Box box;                                      // from the mirror planes on
    operators::Tensor tensor = operators::Tensor::deviator;
    Scene::Operators operators;
    std::vector<operators::VolumeSpectrum> spectrum;  // one, or none without a box
    Field strain;                                     // before the increment plus the last guess
    Field equivalent;                                 // before the increment
    Field backstress;         // before the increment, [term][component][cell]
    std::vector<int> active;  // per cell: its place among the active ones, or -1
    bool strained = false;
    double rim_displacement = 0.0;  // largest residual displacement at the rim of the window
    OutsideStrain outside;          // what the history outside of the box does
    Field given_stress;             // of that and of past heat, as the strain in its box
    double offset = 0.0;            // of its cells from the grid's, see Placement
    operators::Tractions seen;      // the tractions from there; see tractions_on()
    std::shared_ptr<const Field> softening;  // of the yield stress [k][i][j] of the grid
    double weakest = 1.0;                    // its smallest value
    int copies = 1;  // 2: the other body is its mirror image in the contact plane
  };

  fft::Symmetry choose_symmetry() const;
  /// Whether both bodies are made of the same, and have gone and go through the same.
  bool twins() const;
  void set_box(Body& body, const Box& box);
  /// A stored box for what is needed, given in whole boxes.
  Box fit(const Box& needed, const Box& before) const;
  void scatter(const Field& guess);
  void residual_displacement(Body& body, Field& gap);
  /// Adds a surface field of a body, on a box from the mirror planes on, to the gap.
  void open(const Body& body, const Box& box, const Field& displacement, Field& gap) const;
  contact::Solution solve_contact(const Field& gap, double tol);
  void look_from_bodies();
  const operators::Tractions& tractions_on(const Body& body) const;
  /// Whether the residual displacement, which is known over the boxes only, could close the gap
  /// somewhere else.
  bool may_touch_outside(const Field& gap) const;
  /// Once, when the first contact tells how hot the bodies are.
  void soften();
  /// The place of a box's cell in fields of the whole grid.
  std::size_t grid_cell(const Body& body, std::uint32_t cell) const;
  Box contact_window(const Body& body) const;
  /// Whether a box had to grow for the contact or, at first, for the elastic stress.
  bool fit_boxes(const Field& gap);
  /// Stress of the active cells, and the cells that yield and were not active: now they are.
  void stress(std::uint8_t b, Field& guess, Result& result);
  void activate(std::uint8_t b, std::uint32_t cell, const plasticity::Tensor& stress);
  void return_map(const Field& guess, Field& mapped, Result& result);
  /// Those of one cell before the increment, into the first places; how many.
  static std::span<const plasticity::Tensor> backstresses(const Body& body, std::uint32_t cell,
                                                          plasticity::Tensors& place);
  void remember_flow(State& state, const Field& mapped) const;
  /// Active cell number n, at the end of the increment; flow at the border counts against the
  /// `largest` plastic strain of the body.
  void flow(State& state, Body& body, std::size_t n, const Field& mapped, double largest) const;
  /// Grows the boxes whose rim flows.
  bool grow_at_rim();

  const State& from_;
  const Target& target_;
  const Settings& settings_;
  Counters& counters_;
  const Scene& scene_;
  std::vector<Body> bodies_;  // inelastic ones
  int components_ = 5;
  operators::Tractions tractions_;  // [i][j] of the grid
  Field initial_gap_;
  HeatOfIncrement heat_;
  fft::Symmetry symmetry_;
  Field gap_;  // without the elastic displacement, of the last evaluation
  bool scanned_ = false, softened_ = false;
  ActiveCells active_;
  std::vector<plasticity::Tensor> stress_;  // of the active cells
  Field base_;        // plastic strain of the active cells before the increment
  Field equivalent_;  // increment of the active cells, of the last evaluation
};

}  // namespace samcontact::simulation
