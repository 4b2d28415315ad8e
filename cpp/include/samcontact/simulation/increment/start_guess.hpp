// SPDX-License-Identifier: GPL-3.0-or-later
// Initial estimate of the plastic strain increment: that of the last increment, if the loading
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

  /// Unknowns of the cells that it activates; empty: no estimate.
  Field find(std::vector<PlasticBody>& bodies, ActiveCells& active) const;
  /// Whether the contact moves on without change.
  bool is_steady() const;
  /// Stores the plastic strain increment for the estimate of the next increment.
  void remember(const std::vector<PlasticBody>& bodies, const ActiveCells& active,
                const Field& increment, State& state) const;

 private:
  /// Fraction of the last increment of the same steady motion; 0: it was a different one.
  double part_of_last_motion() const;
  /// Fraction of the last increment of a stationary load or approach in the same direction; 0: it
  /// was a different one.
  double part_of_last_load() const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
};

}  // namespace samcontact::simulation
