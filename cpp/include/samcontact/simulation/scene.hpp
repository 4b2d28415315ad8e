// SPDX-License-Identifier: GPL-3.0-or-later
// What does not change during a simulation, and the operators of its bodies.
#pragma once

#include <array>
#include <list>
#include <memory>
#include <mutex>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/volume_operators.hpp"
#include "samcontact/plasticity/material.hpp"

namespace samcontact::simulation {

/// Bodies are indexed 0 (upper) and 1 (lower).
class Scene {
 public:
  Scene(const Grid& grid, const plasticity::Material& body1, const plasticity::Material& body2,
        Field initial_gap, double friction, double image_tol);

  const Grid grid;
  const std::array<plasticity::Material, 2> materials;
  const Field initial_gap;
  const contact::ContactSolver solver;

  /// Throws std::invalid_argument for a grid without volume or a rigid body.
  void require_volume(int body) const;

  using Operators = std::shared_ptr<const operators::VolumeOperators>;
  /// Operators of a body on boxes of this size; bodies with equal elastic constants share them. The
  /// last few are kept. Thread-safe.
  Operators volume(int body, const Box& box, operators::Tensor tensor,
                   operators::ResidualMethod method) const;

  /// Memory of the operators that are kept.
  std::size_t operator_bytes() const;

 private:
  struct Kept {
    int body;
    Box size;
    operators::Tensor tensor;
    operators::ResidualMethod method;
    Operators operators;
  };

  double image_tol_;
  mutable std::mutex mutex_;
  mutable std::list<Kept> kept_;  // the latest used first
};

}  // namespace samcontact::simulation
