// SPDX-License-Identifier: GPL-3.0-or-later
// Incremental elastic-plastic contact: loading, unloading, reloading.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "samcontact/simulation/increment/settings.hpp"
#include "samcontact/simulation/increment/target.hpp"
#include "samcontact/simulation/setup/yield_scan.hpp"
#include "samcontact/simulation/state/counters.hpp"
#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Per increment the plastic strain increment D is the fixed point of: residual displacement of
/// eps + D -> contact -> stress -> radial return of dev(stress) + 2 G D. At the fixed point this is
/// backward Euler with the consistent total strain increment.
class Simulation {
 public:
  /// Throws std::invalid_argument for an invalid gap, or an elastic-plastic body on a grid without
  /// layers.
  Simulation(const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2,
             Field initial_gap, const contact::FrictionLaw& friction, const Settings& settings,
             const TransientHeating& transient_heating = {}, Reliefs reliefs = {},
             contact::SharedContactLaw contact_law = contact::hard_contact(),
             InclusionsPair inclusions = {});

  /// Solves one increment; halves it if the fixed-point iteration does not converge. The current
  /// state changes only on success. Throws std::invalid_argument, GridTooSmallError,
  /// ConvergenceError.
  const State& step(const Target& target);

  /// Sets the plastic state of body 0 or 1 over the cells of a box: any symmetric strain, e.g. a
  /// given eigenstrain. Empty fields: no equivalent plastic strain, no backstress.
  void set_plastic_state(int body, const Box& whole, const Field& strain, const Field& equivalent,
                         const Field& backstress);

  /// Adds an eigenstrain of body 0 or 1 in a box of grid cells whose first layer is k0,
  /// [component][k][i][j] of all six components. Throws std::invalid_argument for a box outside the
  /// grid, a grid without layers, a rigid body, or values that are not finite.
  void add_eigenstrain(int body, const Box& box, int k0, const Field& strain);

  /// Continues from a saved state of an equal setup.
  void restore(const State& state, const Counters& counters);

  const State& state() const { return state_; }
  const Setup& setup() const { return *setup_; }
  const std::shared_ptr<const Setup>& shared_setup() const { return setup_; }
  const Counters& counters() const { return counters_; }
  /// Memory of the plastic state and of the volume kernels [byte].
  std::size_t volume_bytes() const;

 private:
  void check(const Target& target) const;
  /// Strain before any load of bodies with inclusions, due to their misfit and to initial stress.
  void solve_start();
  /// Yield scans of both bodies with the heating of a target.
  const Scans& scans(const operators::HeatingPair& heating);
  /// State at the end of an increment to a target.
  State end_state(const Target& target);
  /// State with heat due to slip: repeated until the heat of the slip equals the heat used in the
  /// solution.
  State heated_by_slip(Target target);
  std::vector<std::string> edge_warnings(const State& reached, const Target& target) const;

  std::shared_ptr<const Setup> setup_;
  Scans scans_;
  operators::HeatingPair scans_heating_;
  Settings settings_;
  State state_;
  Counters counters_;
};

}  // namespace samcontact::simulation
