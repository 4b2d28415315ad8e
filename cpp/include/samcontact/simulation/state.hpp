// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of a simulation: surface fields, plastic state of each body, and every field of the
// volume on demand.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/volume_operators.hpp"
#include "samcontact/plasticity/material.hpp"

namespace samcontact::simulation {

/// What does not change during a simulation. Bodies are indexed 0 (upper) and 1 (lower).
struct Scene {
  Grid grid;
  std::array<plasticity::Material, 2> materials;
  Field initial_gap;
  contact::ContactSolver solver;
  /// Null without a volume or for a rigid body; one object if the elastic constants are equal.
  std::array<std::shared_ptr<const operators::VolumeOperators>, 2> volumes;

  Scene(const Grid& grid, const plasticity::Material& body1, const plasticity::Material& body2,
        Field initial_gap, double friction);
};

/// Plastic history of one body, never changed once made.
struct PlasticState {
  Field strain;      // [component][k][i][j]
  Field equivalent;  // [k][i][j]
};

class State {
 public:
  explicit State(std::shared_ptr<const Scene> scene);

  /// Tractions in the frame of body 2; on body 1 the shear is reversed. Shear arrays may be empty.
  operators::Tractions tractions;
  /// Prescribed tractions: the separation for approach 0, h + u.
  Field gap;
  double load = 0.0;      // [N]
  double approach = 0.0;  // [m]; NaN under prescribed tractions
  std::array<std::shared_ptr<const PlasticState>, 2> plastic;  // null: no plastic strain yet

  bool converged = true;
  int plastic_iterations = 0, contact_iterations = 0, substeps = 0;
  double plastic_residual = 0.0;  // relative change of the plastic strain increment when accepted
  double yield_excess = 0.0;      // max (von Mises - yield)/yield when accepted
  std::vector<std::string> warnings;

  const Scene& scene() const { return *scene_; }
  const std::shared_ptr<const Scene>& shared_scene() const { return scene_; }

  /// Fields of a body (0 or 1), layers at mid-depth: [component][k][i][j] or [k][i][j]. Throw
  /// std::invalid_argument for a grid without volume or a rigid body.
  Field stress(int body) const;
  Field residual_stress(int body) const;
  Field von_mises(int body) const;
  Field hydrostatic(int body) const;
  Field plastic_strain(int body) const;
  Field equivalent_plastic_strain(int body) const;
  /// Surface fields [i][j] [m], positive into the body: of the plastic strain, and of all.
  Field residual_displacement(int body) const;
  Field surface_displacement(int body) const;

 private:
  const operators::VolumeOperators& volume(int body) const;

  std::shared_ptr<const Scene> scene_;
};

}  // namespace samcontact::simulation
