// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of two elastic bodies with partial slip by a friction law: pressure and shear for a
// drive, given the state after the previous increments.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/contact/joint/joint_solver.hpp"
#include "samcontact/contact/laws/friction_conditions.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/attraction.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"

namespace samcontact::contact {

/// State of a contact after an increment: the tractions, which determine the relative tangential
/// position of the surfaces, and the gap of the cells out of contact.
struct ContactHistory {
  Field pressure;  // [i][j] [Pa]; empty: unknown, the normal load is applied first and the shear
                   // second
  Field shear;     // [2][i][j] [Pa], on body 2
  Field gap;       // [i][j] [m]; empty: gap of the present surfaces under these tractions
  RigidMotion motion = {};
  /// Whether the contact has moved over the surfaces: the tractions are given at the present
  /// positions of their cells, and newly contacting cells enter from the side of the contact.
  bool has_moved = false;
  /// Slip of body 1 relative to body 2 since this state that is due neither to rigid motion nor to
  /// tractions [2][i][j] [m]; empty: zero.
  Field free_slip = {};
};

/// Start of the iteration; empty: the state after the previous increment.
struct PartialSlipStart {
  Field pressure = {};  // [i][j] [Pa]
  Field shear = {};     // [2][i][j] [Pa]
  /// Cells that stick [i][j]; empty: all cells with a shear below the bound.
  std::vector<unsigned char> sticking = {};
  std::array<double, 3> motion = {};  // of directions with a prescribed force [m, m, rad]
  /// Whether pressure and shear are solved together from the start, without sweeps: for a contact
  /// close to one whose sweeps stalled.
  bool jointly = false;
};

struct PartialSlipSolution {
  Solution normal;  // its tractions contain the pressure only; its work includes that of the shear
  ShearSolution tangential;
  int sweeps = 1;        // alternations between pressure and shear
  JointWork joint = {};  // of the solution for both together; no steps: the sweeps converged
  /// Message that this state with the smallest error has not converged; empty: converged.
  std::string stall_warning = {};
  /// Slip rate that the friction of each cell follows [i][j] [m/s]; empty: the law does not depend
  /// on it.
  Field slip_rate = {};
  /// Plastic slip of the layer between the bodies so far [i][j] [m]; empty: it does not harden.
  Field plastic_slip = {};
  /// Largest decrease of the bound of a cell due to the slip that a unit decrease of its shear
  /// causes. If it is 1 or more, there may be one solution in which the cell sticks and another in
  /// which it slips.
  double falling_number = 0.0;
  int rate_iterations = 0;  // of the slip rate or the plastic slip
};

/// Solution for an initial pressure, a start and the conditions of friction.
using SolveUnder =
    std::function<PartialSlipSolution(Field, const PartialSlipStart&, const FrictionConditions&)>;
/// Whether the contact is in steady rolling, and the tolerance of the solution.
struct RateSettings {
  bool rolls = false;
  double tol = 1e-8;
};

class PartialSlipContact {
 public:
  /// friction: a law with stick, applied to the repulsion. Throws std::invalid_argument if both
  /// bodies are rigid.
  PartialSlipContact(const Grid& grid, const operators::SharedMedium& body1,
                     const operators::SharedMedium& body2, const FrictionLaw& friction,
                     SharedContactLaw law = hard_contact());

  /// Solves one increment. Identical materials: the pressure, then the shear. Dissimilar materials:
  /// pressure and shear in turn (Panagiotopoulos), each for the displacement due to the other, with
  /// acceleration; if all cells stick, a sweep reduces the error by the square of Dundurs' second
  /// constant. If the sweeps stall, settings.after_stall states what follows. Throws
  /// std::invalid_argument (invalid input, a force above the friction limit), GridTooSmallError and
  /// ConvergenceError.
  PartialSlipSolution solve(const Field& gap, const Drive& drive, const TangentialDrive& tangential,
                            const ContactHistory& before, const PartialSlipStart& start,
                            const ContactSettings& settings,
                            const FrictionConditions& conditions = {}) const;

  /// Solves steady rolling towards +x with creepages along x and y and a spin, per distance rolled
  /// [-, -, 1/m], or with the corresponding forces. Slip [-] and friction work [N] of the solution
  /// are per distance rolled as well. displacement: additional tangential displacement of body 2
  /// less that of body 1 [2][i][j] [m]; empty: zero. Throws as solve() does.
  PartialSlipSolution roll(const Field& gap, const Drive& drive, const TangentialDrive& creepage,
                           const PartialSlipStart& start, const ContactSettings& settings,
                           const FrictionConditions& conditions = {},
                           const Field& displacement = {}) const;

  const Grid& grid() const { return grid_; }
  const FrictionLaw& friction() const { return friction_; }
  const ContactLaw& law() const { return *law_; }
  /// Whether pressure and shear are coupled.
  bool is_coupled() const { return coupling_.is_on(); }

 private:
  class Sweeps;
  class AdhesiveSlip;  // in adhesive_slip.cpp
  /// Solves for forces below the strength of a layer that hardens before the increment.
  PartialSlipSolution solve_driven(const Field& gap, const Drive& drive,
                                   const TangentialDrive& tangential, const ContactHistory& before,
                                   const PartialSlipStart& start, const ContactSettings& settings,
                                   const FrictionConditions& conditions) const;
  PartialSlipSolution with_conditions(const SolveUnder& solve, Field pressure,
                                      const PartialSlipStart& start,
                                      const FrictionConditions& given,
                                      const RateSettings& settings) const;
  void require_contact(const Field& gap, const Drive& drive, const ContactHistory& before) const;
  /// Largest displacement of a cell under its own unit shear, in the last solve [m/Pa].
  double self_influence(bool rolls) const { return shear_.self_influence(rolls); }
  /// Completes the solution for the repulsion: edge of the grid, attraction, errors.
  PartialSlipSolution finished(PartialSlipSolution solution, const Drive& drive,
                               const Attraction& attraction, const ContactSettings& settings) const;

  Grid grid_;
  FrictionLaw friction_;
  SharedContactLaw law_;
  std::unique_ptr<const AdhesiveContact> adhesive_;  // null: the law does not vary with the gap
  double crosswise_;                                 // crosswise_compliance() [-]
  Multilevel normal_;
  ShearSolver shear_;
  operators::NormalTangentialCoupling coupling_;
  JointSolver joint_;
};

}  // namespace samcontact::contact
