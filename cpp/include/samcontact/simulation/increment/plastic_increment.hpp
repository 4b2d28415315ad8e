// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed point of one increment: contact, stress and radial return for a given guess of the
// plastic strain increment.
#pragma once

#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/slip_history.hpp"
#include "samcontact/simulation/increment/start_guess.hpp"
#include "samcontact/simulation/increment/zone_manager.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

/// The unknown is the plastic strain increment of the active cells, [cell][component].
class PlasticIncrement {
 public:
  explicit PlasticIncrement(const IncrementTask& task);
  // Its parts refer to each other.
  PlasticIncrement(const PlasticIncrement&) = delete;
  PlasticIncrement& operator=(const PlasticIncrement&) = delete;
  PlasticIncrement(PlasticIncrement&&) = delete;
  PlasticIncrement& operator=(PlasticIncrement&&) = delete;
  ~PlasticIncrement() = default;

  struct Result {
    contact::Solution contact;
    double excess = 0.0;     // largest relative yield excess of the stress
    double overshoot = 0.0;  // largest relative yield excess of the trial stress
    /// Euclidean norm, over the cells that flow now or in the guess, of the strain at yield, yield
    /// stress / 3 G.
    double yield_strain_norm = 0.0;
    /// Smallest (yield stress - von Mises)/yield stress of the cells that are not active.
    double headroom = 1.0;
    bool grown = false;  // a zone was too small: evaluate again before accepting
  };

  /// A guess to start from; may be empty.
  Field first_guess() { return guess_.find(bodies_, active_); }

  /// mapped = G(guess). New active cells are appended to both. contact_tol applies to load and
  /// approach.
  Result evaluate(Field& guess, double contact_tol, Field& mapped);

  /// The zones, which after an evaluation may have to grow: evaluate again then.
  ZoneManager& zones() { return zones_; }

  /// The contact of the last evaluation to a finer tolerance; all else stays.
  void refine_contact(double contact_tol, Result& result);

  bool has_plastic_body() const { return !bodies_.empty(); }

  /// The state after the increment `mapped` of the last evaluation; ends the use of this object.
  State finish(const Field& mapped, const Result& result);

 private:
  void make_bodies();
  void scatter(const Field& guess);
  contact::Solution solve_contact(const Field& gap, double tol);
  void return_map(const Field& guess, Field& mapped, Result& result);
  /// What a body, number b of the inelastic ones, has become.
  void finish(std::size_t b, const Field& mapped, State& state);

  const IncrementTask task_;
  operators::Tractions tractions_;  // [i][j] of the grid
  const Sources sources_;
  SlipHistory slip_;
  const fft::Symmetry symmetry_;
  const bool twins_;  // one body is solved for both
  StartGuess guess_;
  std::vector<PlasticBody> bodies_;  // inelastic ones
  ActiveCells active_;
  ZoneManager zones_;
  Field gap_;  // without the elastic displacement, of the last evaluation
};

}  // namespace samcontact::simulation
