// SPDX-License-Identifier: GPL-3.0-or-later
// Input of the solution of an increment.
#pragma once

#include "samcontact/simulation/increment/settings.hpp"
#include "samcontact/simulation/increment/target.hpp"
#include "samcontact/simulation/setup/yield_scan.hpp"
#include "samcontact/simulation/state/counters.hpp"
#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// References to objects that outlive the increment.
struct IncrementTask {
  const State& from;  // with the bodies at their positions after the increment
  const Target& target;
  const Scans& scans;  // by body, null for an elastic body
  const Settings& settings;
  Counters& counters;

  const Setup& setup() const { return from.setup(); }
};

}  // namespace samcontact::simulation
