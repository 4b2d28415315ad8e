// SPDX-License-Identifier: GPL-3.0-or-later
// Initial estimate of the plastic strain increment: the increment of the last step, if the loading
// continues in the same way.
#pragma once

#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class StartGuess {
 public:
  /// symmetry: mirror planes of the increment.
  StartGuess(const IncrementTask& task, fft::Symmetry symmetry)
      : task_(task), symmetry_(symmetry) {}

  /// Estimated unknowns of the cells, which it activates; empty: no estimate.
  Field find(std::vector<PlasticBody>& bodies, ActiveCells& active) const;
  /// Whether the contact moves on without change.
  bool is_steady() const;
  /// Stores the plastic strain increment for the estimate of the next increment.
  void remember(const std::vector<PlasticBody>& bodies, const ActiveCells& active,
                const Field& increment, State& state) const;

 private:
  /// Size of this increment relative to the last one of the same steady motion; 0 if the last
  /// motion was different.
  double part_of_last_motion() const;
  /// Size of this increment relative to the last one with a stationary contact and a load or
  /// approach in the same direction; 0 if the last increment was different.
  double part_of_last_load() const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
};

}  // namespace samcontact::simulation
