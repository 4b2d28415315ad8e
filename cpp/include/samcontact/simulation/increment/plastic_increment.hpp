// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed-point map of one increment: contact, stress and radial return for a given estimate of the
// plastic strain increment.
#pragma once

#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/contact_temperature.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/relaxing_bodies.hpp"
#include "samcontact/simulation/increment/slip_history.hpp"
#include "samcontact/simulation/increment/start_guess.hpp"
#include "samcontact/simulation/increment/zone_manager.hpp"
#include "samcontact/simulation/sources/sources.hpp"

namespace samcontact::simulation {

/// The unknown is the plastic strain increment of the active cells, [cell][component].
class PlasticIncrement {
 public:
  explicit PlasticIncrement(const IncrementTask& task);
  // The members refer to each other.
  PlasticIncrement(const PlasticIncrement&) = delete;
  PlasticIncrement& operator=(const PlasticIncrement&) = delete;
  PlasticIncrement(PlasticIncrement&&) = delete;
  PlasticIncrement& operator=(PlasticIncrement&&) = delete;
  ~PlasticIncrement() = default;

  struct Result {
    contact::Solution contact;
    double excess = 0.0;  // maximum relative violation of the yield condition by the stress
    double overshoot =
        0.0;  // maximum relative violation of the yield condition by the trial stress
    /// Euclidean norm of the strain at yield, yield stress / 3 G, over the cells with plastic flow
    /// now or in the estimate.
    double yield_strain_norm = 0.0;
    /// Minimum of (yield stress - von Mises stress)/yield stress over the inactive cells.
    double headroom = 1.0;
    /// Euclidean norm of the eigenstrain of mixed cells, or of a fraction of its largest value so
    /// far; 0 without such cells.
    double mismatch_norm = 0.0;
    double mixed_excess = 0.0;  // counterpart of `excess` of mixed cells
    double mixed_change = 0.0;  // norm of its change in this evaluation
    /// Norm of the plastic strain increment of all other cells, and of its change.
    double increment_norm = 0.0, plastic_change = 0.0;
    bool grown = false;  // a zone was too small: evaluate again before accepting the result
  };

  /// Estimate to start from; may be empty.
  Field first_guess();

  /// mapped = G(guess). Newly active cells are appended to both. contact_tol applies to load and
  /// approach.
  Result evaluate(Field& guess, double contact_tol, Field& mapped);

  /// Zones, which may have to grow after an evaluation: the map must then be evaluated again.
  ZoneManager& zones() { return zones_; }

  /// Solves the contact of the last evaluation again with a smaller tolerance; everything else is
  /// unchanged.
  void refine_contact(double contact_tol, Result& result);

  /// Relative error that need not be reduced further with inclusions; 0 without inclusions.
  double mismatch_tol() const;
  bool has_plastic_body() const { return !bodies_.empty(); }

  /// State after the increment `mapped` of the last evaluation; this object must not be used
  /// afterwards.
  State finish(const Field& mapped, const Result& result);

 private:
  void make_bodies();
  void scatter(const Field& guess);
  contact::Solution solve_contact(const Field& gap, double tol);
  void return_map(const Field& guess, Field& mapped, Result& result);
  /// Sets the temperature of inclusions whose expansion differs from that of the matrix.
  void warm(PlasticBody& body);
  void step_mixed(const Field& guess, Field& mapped, Result& result);
  /// Stores the state of elastic-plastic body number b.
  void finish(std::size_t b, const Field& mapped, State& state);

  const IncrementTask task_;
  operators::Tractions tractions_;  // [i][j] of the grid
  const RelaxingBodies relaxing_;
  const Sources sources_;
  SlipHistory slip_;
  const fft::Symmetry symmetry_;
  const bool mirror_images_;  // whether one body is solved for both
  StartGuess guess_;
  std::vector<PlasticBody> bodies_;  // elastic-plastic bodies
  ActiveCells active_;
  ZoneManager zones_;
  ContactTemperature temperature_;
  double largest_mismatch_ = 0.0;  // see State
  Field gap_;                      // without the elastic displacement, from the last evaluation
};

}  // namespace samcontact::simulation
