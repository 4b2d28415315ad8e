// SPDX-License-Identifier: GPL-3.0-or-later
// Where an increment goes: load or approach, motion, tractions and heat.
#pragma once

#include <string>

#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/scene/past_heat.hpp"

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

/// The target in words, for messages.
std::string describe(const Target& target);

}  // namespace samcontact::simulation
