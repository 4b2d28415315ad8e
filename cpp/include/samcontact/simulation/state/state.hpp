// SPDX-License-Identifier: GPL-3.0-or-later
// State of a simulation after an increment: surface fields, and plastic history of each body.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/sources/sources.hpp"
#include "samcontact/simulation/sources/traction_memory.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// Plastic strain increment, as an estimate for the next increment of a motion; also of a
/// stationary load with plastic flow in many zones.
struct PlasticIncrementGuess {
  fft::Symmetry symmetry = fft::Symmetry::none;
  Travel advance{};
  double load = 0.0, approach = 0.0;  // changes in the increment
  struct Body {
    std::vector<Cell> cells;
    Field strain;  // [cell][component], like the unknowns of the increment
  };
  std::array<Body, 2> bodies;
  bool operator==(const PlasticIncrementGuess&) const = default;
};

/// Effect of the strain of a body outside a box that moves with it, for the increments of a motion
/// in which this strain stays as it is.
struct FarEffect {
  int first = 0;               // first cell of the grid on the body when it was found
  int increments = 0;          // for which it has been used
  Box box, surface;            // at that time: cells with known stress and with known displacement
  Field stress, displacement;  // [component][k][i][j] [Pa] and [i][j] [m]
  bool operator==(const FarEffect&) const = default;
};

/// Number of layers of a volume field; empty: the number chosen by the state.
using Layers = std::optional<int>;

class State {
 public:
  State(std::shared_ptr<const Setup> setup, operators::ResidualMethod method);
  /// Empty state, only for the names and types of its described parts.
  static State without_setup() { return {}; }

  /// Tractions in the frame of body 2; on body 1 the shear is reversed. Shear arrays may be empty.
  operators::Tractions tractions;
  /// Separation under load [i][j] [m] if it is known everywhere, else empty: see gap().
  Field contact_gap;
  operators::HeatingPair heating;                   // proportional to the pressure
  PastHeat past;                                    // of all earlier steps, at their end
  fft::Symmetry past_symmetry = fft::Symmetry::xy;  // mirror planes of the earlier heat
  /// Friction power per area due to slip [i][j] [W/m^2]; empty: no heat due to slip.
  Field slip_power;
  Field slip_work;        // friction work per area in the increment [J/m^2], if it causes heat
  double time = 0.0;      // [s], in transient heating and of viscoelastic bodies
  double duration = 0.0;  // of the last step [s], in transient heating
  /// Factor of the yield stress over the grid, and beyond it where the body may flow; null: 1.
  std::array<std::shared_ptr<const BoxField>, 2> softening;
  double load = 0.0;          // [N]
  double approach = 0.0;      // [m]; NaN under prescribed tractions
  contact::AboutAxes tilt{};  // [rad]; likewise 0
  /// Partial slip: slip of body 1 relative to body 2 in the last increment [2][i][j] [m], 0 in
  /// sticking cells; empty: no slip.
  Field slip;
  /// Slip rate that the friction of each cell follows [i][j] [m/s]; empty: the friction law does
  /// not depend on it.
  Field slip_rate;
  Field plastic_slip;              // of a layer that hardens so far [i][j] [m]; empty: none
  double falling_number = 0.0;     // of the last increment, see contact::PartialSlipSolution
  std::array<double, 3> motion{};  // accumulated tangential rigid-body motion [m, m, rad]
  double friction_work = 0.0;      // accumulated since the start [J]
  // Mirror planes of all tangential motion so far.
  fft::Symmetry shear_symmetry = fft::Symmetry::xy;
  std::array<std::shared_ptr<const PlasticState>, 2> plastic;  // null: no plastic strain yet
  /// Plastic strain of cells that inclusions fill, completely or partly, where `plastic` has the
  /// whole eigenstrain; with two phases that of the inclusion, and that of the matrix with the
  /// equivalent strain of the inclusion. Null: none.
  std::array<std::shared_ptr<const PlasticState>, 2> inclusions_flow, matrix_flow;
  /// Largest root mean square so far of the eigenstrain of these cells [-]; empty: none.
  Field largest_mismatch;
  Eigenstrains eigenstrain;  // prescribed, at its present position
  TractionMemories memory;   // of viscoelastic bodies; null: no step yet
  operators::ResidualMethod method{};
  Travel travel{};
  Travel advance{};  // travel of the last call of moved()
  /// Strain for which the tractions were found, if it has been changed since then; null: unchanged.
  std::array<std::shared_ptr<const PlasticState>, 2> met{};
  /// Disjoint whole boxes in which the plastic strain was last solved for.
  std::array<std::vector<Box>, 2> flow_boxes;
  std::shared_ptr<const PlasticIncrementGuess> last_flow;  // null: no useful estimate
  /// Of inclusions far from the contact. Null: to be found.
  std::array<std::shared_ptr<const FarEffect>, 2> far_effect;

  bool converged = true;
  int plastic_iterations = 0, contact_iterations = 0, substeps = 0;
  double plastic_residual = 0.0;  // relative change of the plastic strain increment at convergence
  double yield_excess = 0.0;  // max (von Mises stress - yield stress)/yield stress at convergence
  std::array<bool, 2> flowed{};  // whether a body had plastic flow in this increment
  std::vector<std::string> warnings;
  /// Newton steps on pressure and shear together in the last increment; 0: the sweeps converged.
  int joint_steps = 0;
  /// Message that pressure and shear did not converge in this increment, and that this is the state
  /// with the smallest error; empty: converged, or read from a checkpoint.
  std::string stall_warning;

  const Setup& setup() const { return *setup_; }
  const std::shared_ptr<const Setup>& shared_setup() const { return setup_; }

  Placement placement() const { return setup_->placement(travel); }
  /// Copy with the bodies moved; nothing is solved.
  State moved(const Travel& to) const;
  /// Copy on the grid of another setup, which differs only in its larger grid with equal numbers of
  /// added cells on both sides. Throws std::invalid_argument for any other grid, and for a state
  /// with a heat history or softening.
  State widened(std::shared_ptr<const Setup> to) const;

  /// Force due to shear on body 2 along x and y, and its moment about z at the origin of the grid
  /// [N, N, N m].
  std::array<double, 3> tangential_force() const;
  /// Moments of the pressure on body 2 about x and y at the origin of the grid [N m].
  contact::AboutAxes moment() const;
  contact::RigidMotion rigid_motion() const { return {approach, tilt}; }

  /// Heat history for the next step, including this one.
  PastHeat heat_so_far() const;
  /// With the heat of bodies that move by some cells, if it follows their travel.
  PastHeat heat_so_far(const Travel& by) const;
  fft::Symmetry heat_symmetry_so_far() const;
  /// Heat of the bodies that is not proportional to the pressure.
  std::array<GivenHeat, 2> given_heat() const {
    return simulation::given_heat(*setup_, heating, past, duration, slip_power);
  }
  /// Sources, which refer to this state.
  Sources sources() const {
    return {*setup_, travel, given_heat(), eigenstrain, method, delayed()};
  }

  /// Tractions whose elastic displacement a viscoelastic body has in addition to that of the
  /// present tractions [i][j]; empty: none.
  std::array<TrackTractions, 2> delayed() const;
  /// Tractions whose elastic displacement a body has [i][j].
  operators::Tractions equivalent_tractions(int body) const;
  /// Energy dissipated by the viscosity of a body since the start [J].
  double viscous_work(int body) const;

  /// Number of layers of volume fields: that of the grid, or enough for all plastic strain and for
  /// the stress below the contact.
  int layers() const;

  /// Cells of the grid down to a number of layers.
  Box below(Layers layers) const;
  /// Tractions on the cells of a body.
  operators::Tractions tractions_on(int body) const;

 private:
  State() = default;

  std::shared_ptr<const Setup> setup_;
};

}  // namespace samcontact::simulation
