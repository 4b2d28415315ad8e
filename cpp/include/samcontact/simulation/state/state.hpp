// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of a simulation: surface fields, and plastic state of each body.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/scene/scene.hpp"
#include "samcontact/simulation/sources/sources.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// What flowed in an increment, as a guess for the next one of a motion; and of a load at rest,
/// where it flowed in many zones.
struct Flow {
  fft::Symmetry symmetry = fft::Symmetry::none;
  Travel advance{};
  double load = 0.0, approach = 0.0;  // their change in it
  struct Body {
    std::vector<Cell> cells;
    Field strain;  // [cell][component], as the increment's unknowns
  };
  std::array<Body, 2> bodies;
  bool operator==(const Flow&) const = default;
};

/// How many; none: as many as a state has.
using Layers = std::optional<int>;

class State {
 public:
  State(std::shared_ptr<const Scene> scene, operators::ResidualMethod method);
  /// Names and types of the parts of a description, and nothing else.
  static State without_scene() { return {}; }

  /// Tractions in the frame of body 2; on body 1 the shear is reversed. Shear arrays may be empty.
  operators::Tractions tractions;
  /// Separation under load [i][j] where it is known everywhere, else empty: see gap().
  Field contact_gap;
  operators::HeatingPair heating;                   // that goes with the pressure
  PastHeat past;                                    // of all steps before, seen from their end
  fft::Symmetry past_symmetry = fft::Symmetry::xy;  // mirror planes of that
  /// Of friction per area, by what slipped [i][j] [W/m^2]; empty: it heats nothing.
  Field slip_power;
  Field slip_work;                    // the same of the increment [J/m^2], where it heats
  double time = 0.0, duration = 0.0;  // [s], of a march, and of its last step
  /// Factor of the yield stress over the grid, and where the body may flow beyond; null: 1.
  std::array<std::shared_ptr<const BoxField>, 2> softening;
  double load = 0.0;      // [N]
  double approach = 0.0;  // [m]; NaN under prescribed tractions
  /// Of bodies that stick and slip: how body 1 slipped over body 2 in the last increment [2][i][j]
  /// [m], 0 where it stuck; empty: nothing did.
  Field slip;
  std::array<double, 3> motion{};  // along the surface since the start [m, m, rad]
  double friction_work = 0.0;      // since the start [J]
  fft::Symmetry shear_symmetry = fft::Symmetry::xy;  // mirror planes of all such motion so far
  std::array<std::shared_ptr<const PlasticState>, 2> plastic;  // null: no plastic strain yet
  Eigenstrains eigenstrain;                                    // that is given, as it lies now
  operators::ResidualMethod method{};
  Travel travel{};
  Travel advance{};  // by which moved() has just taken it there
  /// The strain with which the tractions were found, where it has been changed since; null: it has
  /// not.
  std::array<std::shared_ptr<const PlasticState>, 2> met{};
  /// Whole boxes in which the plastic strain was last solved for; disjoint.
  std::array<std::vector<Box>, 2> flow_boxes;
  std::shared_ptr<const Flow> last_flow;  // null: none that is of use

  bool converged = true;
  int plastic_iterations = 0, contact_iterations = 0, substeps = 0;
  double plastic_residual = 0.0;  // relative change of the plastic strain increment when accepted
  double yield_excess = 0.0;      // max (von Mises - yield)/yield when accepted
  std::array<bool, 2> flowed{};   // whether a body flowed in this increment
  std::vector<std::string> warnings;

  const Scene& scene() const { return *scene_; }
  const std::shared_ptr<const Scene>& shared_scene() const { return scene_; }

  Placement placement() const { return scene_->placement(travel); }
  /// The same with the bodies moved on, nothing solved.
  State moved(const Travel& to) const;
  /// The same moment in the window of a scene that differs in its larger grid only, by as many
  /// cells on either side. Throws std::invalid_argument for another grid, and where there is past
  /// heat or softening.
  State widened(std::shared_ptr<const Scene> to) const;

  /// Force of the shear on body 2 along x and y, and its moment about z at the origin of the grid
  /// [N, N, N m].
  std::array<double, 3> tangential_force() const;

  /// Past heat as the next step finds it: with that of this one.
  PastHeat heat_so_far() const;
  fft::Symmetry heat_symmetry_so_far() const;
  /// Heat of the bodies that does not go with the pressure.
  std::array<GivenHeat, 2> given_heat() const {
    return simulation::given_heat(*scene_, heating, past, duration, slip_power);
  }
  /// Which refer to this state.
  Sources sources() const { return {*scene_, travel, given_heat(), eigenstrain, method}; }

  /// How many layers fields of the volume have: those of the grid, or enough for all plastic strain
  /// and for the stress under the contact.
  int layers() const;

  /// The cells of the grid down to a number of layers.
  Box below(Layers layers) const;
  /// Tractions as the cells of a body see them.
  operators::Tractions tractions_on(int body) const;

 private:
  State() = default;

  std::shared_ptr<const Scene> scene_;
};

}  // namespace samcontact::simulation
