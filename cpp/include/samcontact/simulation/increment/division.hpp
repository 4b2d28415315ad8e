// SPDX-License-Identifier: GPL-3.0-or-later
// The way to the target of an increment, in as many parts as convergence and the tolerance of
// increments ask for.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class Division {
 public:
  /// scans: those with the heat of a part.
  using ScansOf = std::function<const Scans&(const operators::HeatingPair& heating)>;

  Division(const State& from, const Target& target, const Settings& settings, Counters& counters,
           ScansOf scans);

  /// The state at the target. Throws ConvergenceError where the smallest part does not converge,
  /// std::invalid_argument where the tolerance asks for smaller ones, or for too many.
  State walk();

 private:
  // Places on the way: 0 where it starts, 1 at the target.

  Target part_of(const State& from, double start, double end) const;
  State moved_to(const State& from, double end) const;
  State increment(const State& from, const Target& part);
  State solve(const State& from, double start, double end);
  /// The state at the end of the next part; none where its error is too large. factor: of its
  /// length for the one to try after it.
  std::optional<State> next_part(double end, double& factor);
  /// The same from a solution in one part, and one in two.
  std::optional<State> extrapolate(const State& once, double end, double& factor);

  /// Throws std::invalid_argument: the tolerance asks for such parts.
  [[noreturn]] void refuse(const std::string& parts) const;

  const State& from_;
  const Target& target_;
  const Settings& settings_;
  Counters& counters_;
  ScansOf scans_;
  State moment_;
  double done_ = 0.0;
  int iterations_ = 0, substeps_ = 0;
  int short_parts_ = 0;  // of the substeps, those as short as the tolerance asks for
};

}  // namespace samcontact::simulation
