// SPDX-License-Identifier: GPL-3.0-or-later
// Incremental elastic-plastic contact: loading, unloading, reloading.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "samcontact/simulation/state.hpp"
#include "samcontact/simulation/yield_scan.hpp"

namespace samcontact::simulation {

/// Where an increment goes.
struct Target {
  contact::Drive drive = contact::Drive::load(0.0);
  /// Of bodies that stick and slip, besides the difference of their ways; in the increment.
  contact::TangentialDrive tangential = contact::held;
  /// On body 2; with a pressure no contact is driven and solved. Without shear it has that of the
  /// law of the contact.
  operators::Tractions tractions = {};
  Travel advance{};                     // on the way there
  operators::HeatingPair heating = {};  // that goes with the pressure
  /// Of the increment [s], in a march in time, where it is the age of the heating too; and with
  /// heat of slip, which is that of the increment on the mean.
  double duration = 0.0;
  PastHeat past = {};     // filled in by the simulation
  Field slip_power = {};  // the same, of heat of slip
  fft::Symmetry past_symmetry = fft::Symmetry::xy;

  bool is_prescribed() const { return !tractions.pressure.empty(); }
  bool is_load() const { return !is_prescribed() && drive.normal.is_force(); }
  bool is_approach() const { return !is_prescribed() && !drive.normal.is_force(); }
};

/// Factor of a body's yield stress from the rise of temperature [K], both [k][i][j] of a box.
using Softening = std::function<Field(const Field& temperature, const Box& box)>;

/// Defaults and ranges are the caller's.
struct Settings {
  double tol;  // relative change of the plastic strain increment, and yield excess
  /// Error of the division into increments, by step doubling; 0: increments as given.
  double increment_tol;
  int max_iterations;
  contact::OnBorder on_border;
  operators::ResidualMethod residual_stress;
  /// Fast residual stress: error due to periodic images, relative to the largest stress.
  double image_tol;
  /// How far beyond the grid plastic strain acts along x [cells].
  int reach;
  /// Plastic strain in one box always, never in small zones.
  bool one_zone = false;
  /// How the operators of small zones are split in bands.
  operators::BandSplit split = {};
  int max_halvings = 8;
  /// By body; empty: none. Asked once an increment, or part of one.
  std::array<Softening, 2> softening = {};
};

/// By body; null where nothing can yield.
using Scans = std::array<std::shared_ptr<const YieldScan>, 2>;

/// Work done so far.
struct Counters {
  long contact_solves = 0, contact_iterations = 0;
  long yield_checks = 0;        // increments whose elastic state was compared with the yield stress
  long plastic_solves = 0;      // (sub)increments in which a body yielded
  long plastic_iterations = 0;  // evaluations of the plastic fixed point
  long halvings = 0;
};

/// Per increment the plastic strain increment D is the fixed point of: residual displacement of
/// eps + D -> contact -> stress -> radial return of dev(stress) + 2 G D. At the fixed point this is
/// backward Euler with the consistent total strain increment.
class Simulation {
 public:
  /// Throws std::invalid_argument: wrong gap, an inelastic body on a grid without volume.
  Simulation(const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2,
             Field initial_gap, const contact::FrictionLaw& friction, const Settings& settings,
             const HeatMarch& march = {}, Reliefs reliefs = {});

  /// One increment; halves it where the fixed point does not converge. The present state changes
  /// only on success. Throws std::invalid_argument, GridTooSmallError, ConvergenceError.
  const State& step(const Target& target);

  /// Plastic state of body 0 or 1 to go on from: any symmetric strain, e.g. a given eigenstrain.
  /// Over the cells of a box. Without equivalent plastic strain or backstress when these are empty.
  void set_plastic_state(int body, const Box& whole, const Field& strain, const Field& equivalent,
                         const Field& backstress);

  /// Continues from a saved state of the same scene.
  void restore(const State& state, const Counters& counters);

  const State& state() const { return state_; }
  const Scene& scene() const { return *scene_; }
  const std::shared_ptr<const Scene>& shared_scene() const { return scene_; }
  const Counters& counters() const { return counters_; }
  /// Memory of the plastic state and the volume's kernels.
  std::size_t volume_bytes() const;

 private:
  void check(const Target& target) const;
  /// With the heat of a target.
  const Scans& scans(const operators::HeatingPair& heating);
  /// The state at a target.
  State reached(const Target& target);
  /// The same with heat of slip: solved until slip makes the heat that it was solved with.
  State heated_by_slip(Target target);
  std::vector<std::string> border_complaints(const State& reached, const Target& target) const;

  std::shared_ptr<const Scene> scene_;
  Scans scans_;
  operators::HeatingPair scans_heating_;
  Settings settings_;
  State state_;
  Counters counters_;
};

}  // namespace samcontact::simulation
