// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal softening in an increment: the yield stress of bodies that its contact heats.
#pragma once

#include <array>
#include <memory>

#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class ThermalSoftening {
 public:
  explicit ThermalSoftening(const IncrementTask& task);

  /// Softens a body in the volume below its contact and in a box, once: where the first contact
  /// tells how hot it is. Throws std::invalid_argument for a law that gives no factor.
  void apply(PlasticBody& body, const Box& box);
  /// Softens it by the same contact in another box as well, where it is softened already.
  void extend(PlasticBody& body, const Box& box) const;

 private:
  void soften(PlasticBody& body, const Box& box) const;
  /// Factor of the yield stress in a box; null: 1 everywhere.
  std::shared_ptr<const BoxField> factor(int body, const Box& box) const;

  IncrementTask task_;
  std::array<GivenHeat, 2> given_;
  std::array<double, 2> offsets_;
  std::array<Field, 2> pressure_;  // on each body, of the first contact; empty before
};

}  // namespace samcontact::simulation
