// SPDX-License-Identifier: GPL-3.0-or-later
// The first guess of the plastic flow of an increment: that of the last one, where the bodies go on
// in the same way.
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

  /// The unknowns of cells that it activates; empty: no guess.
  Field find(std::vector<PlasticBody>& bodies, ActiveCells& active) const;
  /// Whether the contact goes on and stays the same.
  bool is_steady() const;
  /// Keeps the flow of the increment for the guess of the next one.
  void remember(const std::vector<PlasticBody>& bodies, const ActiveCells& active,
                const Field& increment, State& state) const;

 private:
  /// Part of the last increment of the same steady motion; 0: it was none.
  double part_of_last_motion() const;
  /// The same of a load or approach that goes on in the same direction, at rest.
  double part_of_last_load() const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
};

}  // namespace samcontact::simulation
