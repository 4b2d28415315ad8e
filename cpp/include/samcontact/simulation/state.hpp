// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of a simulation: surface fields, plastic state of each body, and every field of the
// volume on demand.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samcontact/simulation/given_heat.hpp"
#include "samcontact/simulation/plastic_state.hpp"
#include "samcontact/simulation/scene.hpp"
#include "samcontact/simulation/strength.hpp"

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

/// A scalar field of the cells of a box, [k][i][j].
struct BoxField {
  Box box;
  Field values;
  double at(int i, int j, int k) const {
    return values[(static_cast<std::size_t>(k) * box.nx + (i - box.i0)) * box.ny + (j - box.j0)];
  }
};

/// How many; none: as many as a state has.
using Layers = std::optional<int>;

class State {
 public:
  State(std::shared_ptr<const Scene> scene, operators::ResidualMethod method);

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
  operators::ResidualMethod method;
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
  /// Heat that does not go with its pressure.
  GivenHeat given_heat(int body) const {
    return {*scene_, body, past[body], duration, heating[body], slip_power};
  }

  /// Separation of the surfaces under load [i][j] [m]; under prescribed tractions for approach 0.
  Field gap() const;

  /// How many layers fields of the volume have: those of the grid, or enough for all plastic strain
  /// and for the stress under the contact.
  int layers() const;

  /// Fields of a body (0 or 1), layers at mid-depth: [component][k][i][j] or [k][i][j], in the
  /// body's cells (see Placement). Throw std::invalid_argument for a grid without volume or a rigid
  /// body.
  /// Both with the stress that is there from the start.
  Field stress(int body, Layers layers = {}) const;
  Field residual_stress(int body, Layers layers = {}) const;
  /// The stress that is there from the start.
  Field initial_stress(int body, Layers layers = {}) const;
  Field initial_stress(int body, const Box& region) const;
  /// Factor of the yield stress by its profile over depth.
  Field yield_factor(int body, const Box& region) const;
  Field plastic_strain(int body, Layers layers = {}) const;
  Field equivalent_plastic_strain(int body, Layers layers = {}) const;
  /// The cells with plastic strain, where fields do not have all of them; else empty. Along x
  /// only what has flowed where it is: what has moved is on the track.
  Box strain_beyond(int body) const;
  /// Largest accumulated equivalent plastic strain, and largest sqrt(2/3 e:e) of the plastic
  /// strain, which flow to and fro does not raise; 0 for a body without.
  double max_equivalent_plastic_strain(int body) const;
  /// Cells that have yielded, wherever they lie.
  std::size_t plastic_cells(int body) const;
  double max_plastic_strain_magnitude(int body) const;
  /// [term][component][k][i][j], as many terms as the material has backstresses.
  Field backstress(int body, Layers layers = {}) const;
  Field backstress(int body, const Box& region) const;
  /// Fields of the plastic strain over cells of the body beside or in the grid; [i][j] or
  /// [component][k][i][j] of the region.
  Field residual_displacement(int body, operators::Axis axis, const Box& region) const;
  Field residual_stress(int body, const Box& region) const;
  Field plastic_strain(int body, const Box& region) const;
  Field equivalent_plastic_strain(int body, const Box& region) const;

  /// Disjoint boxes with all plastic strain of a body: those it was solved for in, or one box of
  /// what fields show.
  std::vector<Box> zones(int body) const;
  /// Stress in them, all of it or that of the plastic strain, [zone][component][k][i][j].
  Field stress_in_zones(int body, bool with_tractions) const;

  /// The box that the plastic strain was last solved for in, down to the layers of the grid, where
  /// it is one and holds all tractions; else empty.
  Box own_box(int body) const;
  /// Deviator of the stress in it, all of it or that of the plastic strain, [component][k][i][j],
  /// by the operators of the increment.
  Field deviator_in_own_box(int body, bool with_tractions) const;

  /// Surface fields [i][j] [m]: displacement along an axis due to the plastic strain, and u_z, into
  /// the body, due to all.
  Field residual_displacement(int body, operators::Axis axis) const;
  Field surface_displacement(int body) const;
  /// Rise of temperature [K] at mid-depth of the layers [k][i][j], and of the surface [i][j].
  Field temperature(int body, Layers layers = {}) const;
  Field surface_temperature(int body) const;

 private:
  /// Of tractions and plastic strain.
  Field total_stress(int body, bool with_tractions, const Box& region) const;
  /// Of plastic strain.
  Field stress_of_strain(int body, const Box& region) const;
  Strength strength(int body) const;
  fft::Symmetry stress_symmetry(int body, bool with_tractions) const;
  /// The cells of the grid down to a number of layers.
  Box below(Layers layers) const;
  /// As the body's cells see them.
  operators::Tractions tractions_on(int body) const;
  /// Whether its plastic strain was last solved for in small zones.
  bool is_in_zones(int body) const;
  /// The same, and all stress is that of the strain and of tractions.
  bool shows_zones(int body) const;
  /// Whether its plastic strain was last solved for elsewhere than in its one box.
  bool is_elsewhere(int body) const;

  std::shared_ptr<const Scene> scene_;
};

/// Shear [2][i][j]; empty where there is none.
Field shear_vectors(const operators::Tractions& tractions);
/// The part of the surface fields over a box; 0 beside the grid.
operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box);

}  // namespace samcontact::simulation
