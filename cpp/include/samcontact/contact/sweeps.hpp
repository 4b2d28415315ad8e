// SPDX-License-Identifier: GPL-3.0-or-later
// Solution of one increment with partial slip: alternating sweeps for pressure and shear; if they
// stall, both together.
#pragma once

#include "samcontact/contact/joint/joint_solver.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

class PartialSlipContact::Sweeps {
 public:
  Sweeps(const PartialSlipContact& contact, const Field& gap, const Drive& drive,
         const TangentialDrive& tangential, const ContactHistory& before,
         const FrictionConditions& friction, const ContactSettings& settings, bool rolls = false);

  /// Coupled bodies interact through raised_, which is iterated until it equals the displacement
  /// due to the shear.
  PartialSlipSolution run(Field pressure, const PartialSlipStart& start);

 private:
  /// Sweeps until convergence or stall.
  void alternate(Field pressure);
  /// Solves for the pressure at the present normal displacement due to shear.
  void solve_pressure(Field pressure, double tol);
  /// Replaces a displacement by its decrease from the next cell ahead, per distance rolled.
  void difference_per_distance(Field& displacement) const;
  /// Solves for the shear under the present pressure.
  void solve_shear(double tol);
  /// Shear of the history, scaled to the present bound in cells that slipped; empty: none.
  Field shear_before() const;

  /// Part of a rigid motion that newly contacting cells slip; empty if there are none, and before
  /// the first contact, for which the normal load is applied first.
  Field slip_part(const Field& pressure, const RigidMotion& motion, double load);
  /// Gap before the increment, scaled so that a uniform approach by `closer` closes it at the same
  /// times as a motion that tilts the bodies.
  Field gap_of_uniform_approach(const RigidMotion& motion, double& closer) const;
  /// Contact area [m^2].
  double area(const Field& pressure) const;
  /// Approximate maximum of the prescribed slip [m].
  double given_motion(double area) const;
  /// Gap of the present undeformed surfaces under the previous tractions.
  Field find_gap_before();
  void raise(const Field& shear, Field& raised);
  /// Updates gap and pressure error for the present shear; returns the normal displacement due to
  /// the shear in excess of raised_.
  Field update_gap();

  // Pressure and shear together, in sweeps_joint.cpp.

  /// Replaces the present solution by one for pressure and shear together; if it does not converge,
  /// by the state with the smallest error.
  void solve_jointly();
  /// Data of the increment. The slip of a cell includes the part before it touches: that part is
  /// discontinuous where the approach begins to increase, and there might be no solution.
  JointProblem joint_problem();
  /// Slip due to a unit motion in a direction.
  Field direction(int k) const;
  JointState joint_start(const JointProblem& problem, const Field& pressure,
                         const Field& shear) const;
  void take(const JointProblem& problem, const JointSolution& found);
  void take_shear(const JointProblem& problem, const JointState& state);

  const PartialSlipContact& contact_;
  const Field& gap_;
  const Drive drive_;
  const RigidModes modes_;
  const TangentialDrive& tangential_;
  const ContactHistory& before_;
  const FrictionConditions& friction_;
  const ContactSettings& settings_;
  const bool rolls_;
  const std::size_t n_;
  Field raised_;            // assumed B s; empty if it is zero
  Field gap_before_;        // empty: unknown
  Field displaced_before_;  // B' p of the history
  PreviousDisplacement slid_by_shear_;
  ComplexField work_;
  PartialSlipSolution s_;
};

}  // namespace samcontact::contact
