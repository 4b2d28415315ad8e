// SPDX-License-Identifier: GPL-3.0-or-later
// Choice between one box and small zones for the plastic strain of a body, and choice of the zones.
#pragma once

#include <vector>

#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/start_guess.hpp"

namespace samcontact::simulation {

class SplitChoice {
 public:
  /// tractions: of the increment, which change with its contact. All arguments must outlive this
  /// object.
  SplitChoice(const IncrementTask& task, fft::Symmetry symmetry, const StartGuess& guess,
              const operators::Tractions& tractions, const Sources& sources)
      : task_(task),
        symmetry_(symmetry),
        choice_(task.setup().grid, symmetry),
        guess_(guess),
        tractions_(tractions),
        sources_(sources) {}

  /// Whether small zones are allowed.
  bool is_allowed() const;
  /// Whether they require less work than one box.
  bool is_worthwhile(const PlasticBody& body, const std::vector<Box>& boxes) const;
  /// Whether they require less work than this box, by the ratio for bodies at rest.
  bool cost_less(const std::vector<Box>& boxes, const Box& one) const;
  /// Disjoint zones that contain the given boxes.
  std::vector<Box> merged_zones(const std::vector<Box>& boxes) const;
  /// Small zones for a body with a history: the previous zones; for a body that has moved, its
  /// whole history in the grid and the zone of steady plastic flow.
  std::vector<Box> zones_to_begin_with(const PlasticBody& body) const;

 private:
  bool cost_less(const std::vector<Box>& boxes, const Box& one, double max_ratio) const;
  bool is_cold_and_at_rest() const;

  IncrementTask task_;
  fft::Symmetry symmetry_;
  BoxChoice choice_;
  const StartGuess& guess_;
  const operators::Tractions& tractions_;
  const Sources& sources_;
};

}  // namespace samcontact::simulation
