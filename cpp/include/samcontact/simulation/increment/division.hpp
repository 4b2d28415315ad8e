// SPDX-License-Identifier: GPL-3.0-or-later
// Division of an increment into sub-increments, as required for convergence and by the increment
// tolerance.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class Division {
 public:
  /// scans: yield scans with the heating of a sub-increment.
  using ScansOf = std::function<const Scans&(const operators::HeatingPair& heating)>;

  Division(const State& from, const Target& target, Settings settings, Counters& counters,
           ScansOf scans);

  /// State at the target. If the sweeps between pressure and shear stall, sub-increments are tried
  /// first, unless the previous increment has Newton steps; then the increment is repeated with
  /// pressure and shear solved together where sweeps stall; then, if the settings allow it, the
  /// state with the smallest error is accepted. Throws ConvergenceError if the smallest
  /// sub-increment does not converge, and std::invalid_argument if the tolerance requires smaller
  /// ones, or too many.
  State walk();

 private:
  /// Walks with the present settings.
  State walk_parts();
  void restart();
  // Positions along the increment: 0 at its start, 1 at the target.

  Target part_of(const State& from, double start, double end) const;
  Travel travel_at(double end) const;
  State moved_to(const State& from, double end) const;
  State increment(const State& from, const Target& part);
  State solve(const State& from, double start, double end);
  /// State at the end of the next sub-increment; none if the error is too large. factor: factor on
  /// the length of the sub-increment for the next attempt.
  std::optional<State> next_part(double end, double& factor);
  /// Extrapolated state, from a solution in one step and a solution in two steps.
  std::optional<State> extrapolate(const State& once, double end, double& factor);

  /// Throws std::invalid_argument with the message that the tolerance would require smaller or more
  /// sub-increments.
  [[noreturn]] void refuse(const std::string& parts) const;

  const State& from_;
  const Target& target_;
  Settings settings_;
  Counters& counters_;
  ScansOf scans_;
  State moment_;
  double done_ = 0.0;
  bool stalled_ = false;  // whether sweeps have stalled
  int iterations_ = 0, substeps_ = 0;
  int short_parts_ = 0;  // number of sub-increments whose length is limited by the tolerance
};

}  // namespace samcontact::simulation
