// SPDX-License-Identifier: GPL-3.0-or-later
// Counters of the work done by a simulation.
#pragma once

namespace samcontact::simulation {

/// Work done so far.
struct Counters {
  long contact_solves = 0, contact_iterations = 0;
  long yield_checks = 0;        // increments whose elastic state was compared with the yield stress
  long plastic_solves = 0;      // (sub-)increments with plastic flow
  long plastic_iterations = 0;  // evaluations of the plastic fixed-point map
  long halvings = 0;
  long joint_steps = 0;  // Newton steps on pressure and shear together
};

}  // namespace samcontact::simulation
