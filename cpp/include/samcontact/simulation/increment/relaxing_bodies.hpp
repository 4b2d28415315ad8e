// SPDX-License-Identifier: GPL-3.0-or-later
// Viscoelastic bodies in an increment: an elastic contact with factors on the compliances, and with
// displacement that the bodies remember.
#pragma once

#include <array>
#include <optional>

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

class RelaxingBodies {
 public:
  explicit RelaxingBodies(const IncrementTask& task);

  /// Factors on the elastic compliances of the bodies.
  const Compliances& compliances() const { return compliances_; }
  /// Tractions whose elastic displacement the bodies remember; empty: none.
  const std::array<TrackTractions, 2>& remembered() const { return remembered_; }
  /// Slip of body 1 relative to body 2 in the increment that is due to memory [2][i][j]: the
  /// tangential displacement that it causes now, less the part of the previous displacement that
  /// tractions do not cause with the present compliances. before: tractions at the start of the
  /// increment, as the contact compares with them. Empty: none.
  Field slip(const operators::Tractions& before) const;
  /// Stores the memory at the end of the increment in the state after it.
  void remember(const operators::Tractions& tractions, State& state) const;

 private:
  const State& from_;
  std::array<std::optional<RelaxationStep>, 2> steps_;  // none: elastic
  Compliances compliances_ = elastic_compliances;
  std::array<TrackTractions, 2> remembered_;
};

}  // namespace samcontact::simulation
