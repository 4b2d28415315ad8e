// SPDX-License-Identifier: GPL-3.0-or-later
// All that an increment is solved from and for.
#pragma once

#include "samcontact/simulation/increment/settings.hpp"
#include "samcontact/simulation/increment/target.hpp"
#include "samcontact/simulation/scene/yield_scan.hpp"
#include "samcontact/simulation/state/counters.hpp"
#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// References to what outlives the increment.
struct IncrementTask {
  const State& from;  // with the bodies where the increment takes them
  const Target& target;
  const Scans& scans;  // by body, null where nothing can yield
  const Settings& settings;
  Counters& counters;

  const Scene& scene() const { return from.scene(); }
};

}  // namespace samcontact::simulation
