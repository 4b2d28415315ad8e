// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that stick and slip: shear is an unknown of the contact as pressure is, and what the
// plastic strain does along the surface enters its condition of stick.
#pragma once

#include "samcontact/simulation/increment/increment_task.hpp"

namespace samcontact::simulation {

/// The rigid motion of an increment, where bodies that move on also turn and slide by the
/// difference of their ways.
contact::TangentialDrive tangential_drive(const IncrementTask& task);
/// Whether bodies alike that may stick are not sheared.
bool is_free_of_shear(const IncrementTask& task);

class SlipHistory {
 public:
  /// Of no use where the contact does not stick and slip, or is prescribed.
  explicit SlipHistory(const IncrementTask& task);

  /// Whether shear is an unknown.
  bool is_on() const { return on_; }
  /// Slip before plastic strain of the increment slides the bodies, to be added to [2][i][j].
  Field& begin_slip();
  /// Pressure and shear over a gap. start: where the iteration starts.
  contact::Solution solve(const Field& gap, const Field& start,
                          const contact::ContactSettings& settings);
  /// Puts slip, motion and work of the last solution into the state after the increment.
  /// tractions: of the increment.
  void remember(const operators::Tractions& tractions, State& state) const;

 private:
  IncrementTask task_;
  bool on_;
  contact::ContactHistory before_;
  Field carried_apart_;           // slip that goes with different ways of the bodies
  contact::ShearSolution shear_;  // of the last solution
};

}  // namespace samcontact::simulation
