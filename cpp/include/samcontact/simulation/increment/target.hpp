// SPDX-License-Identifier: GPL-3.0-or-later
// Target of an increment: load or approach, motion, tractions and heat.
#pragma once

#include <string>

#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/setup/past_heat.hpp"

namespace samcontact::simulation {

/// Target of an increment.
struct Target {
  contact::Drive drive = contact::Drive::load(0.0);
  /// Under partial slip: rigid motion in the increment in addition to the difference of travel.
  contact::TangentialDrive tangential = contact::held;
  /// On body 2; with a prescribed pressure no contact is solved. Without shear, the shear of the
  /// friction law is used.
  operators::Tractions tractions = {};
  Travel advance{};                     // travel in the increment [cells]
  operators::HeatingPair heating = {};  // proportional to the pressure
  /// Duration of the increment [s]: for transient heating, where it is also the age of the heat,
  /// for heat due to slip, where the power is the mean over the increment, and for viscoelastic
  /// bodies, whose long-time state is reached for an infinite duration.
  double duration = 0.0;
  /// Duration of the increment for friction that depends on the slip rate [s]; 0: not needed.
  double lasts = 0.0;
  PastHeat past = {};     // filled in by the simulation
  Field slip_power = {};  // likewise, power of heat due to slip
  fft::Symmetry past_symmetry = fft::Symmetry::xy;

  bool is_prescribed() const { return !tractions.pressure.empty(); }
  bool is_load() const { return !is_prescribed() && drive.normal.is_force(); }
  bool is_approach() const { return !is_prescribed() && !drive.normal.is_force(); }
};

/// Text that describes the target, for messages.
std::string describe(const Target& target);

}  // namespace samcontact::simulation
