// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal softening in an increment: the yield stress of bodies heated by the contact.
#pragma once

#include <array>
#include <memory>

#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/contact_temperature.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class ThermalSoftening {
 public:
  explicit ThermalSoftening(const IncrementTask& task);

  /// Softens a body in the volume below its contact and in a box, once: the first contact of the
  /// increment gives the temperature rise. Throws std::invalid_argument for a law that does not
  /// return a factor.
  void apply(PlasticBody& body, const Box& box);
  /// Also softens an already softened body in another box, for the temperature of the same contact.
  void extend(PlasticBody& body, const Box& box);

 private:
  void soften(PlasticBody& body, const Box& box);
  /// Factor on the yield stress in a box; null: 1 everywhere.
  std::shared_ptr<const BoxField> factor(int body, const Box& box);

  IncrementTask task_;
  ContactTemperature temperature_;
  std::array<Field, 2> pressure_;  // on each body, from the first contact; empty before
};

}  // namespace samcontact::simulation
