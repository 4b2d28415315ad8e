// SPDX-License-Identifier: GPL-3.0-or-later
// Partial slip in an increment: shear is an unknown of the contact like the pressure, and the
// tangential displacement due to plastic strain enters the stick condition.
#pragma once

#include <memory>
#include <string>

#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/increment/relaxing_bodies.hpp"

namespace samcontact::simulation {

/// Rigid motion of an increment; moving bodies also rotate, and slide by the difference of their
/// travel.
contact::TangentialDrive tangential_drive(const IncrementTask& task);
/// Whether the contact has no unknown shear: full sliding, or identical materials without
/// tangential drive and without previous shear.
bool is_free_of_shear(const IncrementTask& task);

class SlipHistory {
 public:
  /// Has no effect in full sliding or under prescribed tractions.
  SlipHistory(const IncrementTask& task, const RelaxingBodies& relaxing);

  /// Whether shear is an unknown.
  bool is_on() const { return on_; }
  /// Slip before the contribution of the plastic strain of the increment, which is to be added to
  /// [2][i][j].
  Field& begin_slip();
  /// Pressure and shear for a gap, with heat in proportion to the pressure. start: initial pressure
  /// of the iteration.
  contact::Solution solve(const Field& gap, const Field& start,
                          const contact::ContactSettings& settings);
  /// Stores slip, motion and work of the last solution in the state after the increment. tractions:
  /// tractions of the increment.
  void remember(const operators::Tractions& tractions, State& state) const;

 private:
  /// Pressure and shear without the displacement due to heat in proportion to the pressure.
  contact::Solution solve_cold(const Field& gap, const Field& start,
                               const contact::ContactSettings& settings);

  IncrementTask task_;
  bool on_;
  contact::ContactHistory before_;
  std::shared_ptr<const contact::PartialSlipContact> contact_;  // null: no effect
  contact::FrictionConditions conditions_;
  Field slip_rate_;               // of the last solution
  Field plastic_slip_;            // likewise
  double falling_number_ = 0.0;   // likewise
  Field travel_slip_;             // slip due to different travel of the bodies, and to their memory
  contact::ShearSolution shear_;  // of the last solution
  std::string stall_warning_;     // likewise
  int joint_steps_ = 0;           // of all solutions
  bool jointly_ = false;          // whether the last solution was for pressure and shear together
};

}  // namespace samcontact::simulation
