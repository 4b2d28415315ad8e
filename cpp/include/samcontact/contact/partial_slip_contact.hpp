// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of two elastic bodies that stick and slip on each other by a friction law: pressure and
// shear for a drive, from what the increments before have left.
#pragma once

#include <array>
#include <vector>

#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/attraction.hpp"
#include "samcontact/contact/tangential/shear_solver.hpp"

namespace samcontact::contact {

/// What a contact remembers: its tractions, which tell how the surfaces lie against each other, and
/// how far they were apart where they did not touch.
struct ContactHistory {
  Field pressure;  // [i][j] [Pa]; empty: none is known, the bodies are pressed, then sheared
  Field shear;     // [2][i][j] [Pa], on body 2
  Field gap;       // [i][j] [m]; empty: that of the present surfaces under these tractions
  double approach = 0.0;
  /// The contact has moved over the surfaces: tractions are where their cells are now, and what
  /// touches for the first time came into it from its side.
  bool has_moved = false;
  /// How body 1 has slipped over body 2 since by other causes than rigid motion and tractions
  /// [2][i][j] [m]; empty: not at all.
  Field free_slip = {};
};

/// What the iteration begins with; empty: what the increment before has left.
struct PartialSlipStart {
  Field pressure = {};  // [i][j] [Pa]
  Field shear = {};     // [2][i][j] [Pa]
  /// [i][j], which cells stick with it; empty: those below their bound.
  std::vector<unsigned char> sticking = {};
  std::array<double, 3> motion = {};  // where forces are given [m, m, rad]
};

struct PartialSlipSolution {
  Solution normal;  // its tractions hold the pressure only; work counts that of shear too
  ShearSolution tangential;
  int sweeps = 1;  // between pressure and shear
};

class PartialSlipContact {
 public:
  /// friction: a law that sticks, of the repulsion. Throws std::invalid_argument where both bodies
  /// are rigid.
  PartialSlipContact(const Grid& grid, const operators::SharedMedium& body1,
                     const operators::SharedMedium& body2, const FrictionLaw& friction,
                     SharedContactLaw law = hard_contact());

  /// One increment. Bodies alike: pressure, then shear. Else both in turn (Panagiotopoulos), each
  /// for the displacement of the other, accelerated; with stick everywhere a sweep contracts by the
  /// square of Dundurs' second constant. Throws std::invalid_argument (bad input, a force beyond
  /// friction), GridTooSmallError and ConvergenceError.
  PartialSlipSolution solve(const Field& gap, Given normal, const TangentialDrive& tangential,
                            const ContactHistory& before, const PartialSlipStart& start,
                            const ContactSettings& settings) const;

  /// Steady rolling towards +x with creepages along x and y and a spin, per way rolled [-, -, 1/m],
  /// or with the forces that they make; so are slip [-] and friction work [N] of the solution.
  /// Throws as solve does.
  PartialSlipSolution roll(const Field& gap, Given normal, const TangentialDrive& creepage,
                           const PartialSlipStart& start, const ContactSettings& settings) const;

  const Grid& grid() const { return grid_; }
  const FrictionLaw& friction() const { return friction_; }
  const ContactLaw& law() const { return *law_; }
  /// Whether pressure and shear act on each other.
  bool is_coupled() const { return coupling_.is_on(); }

 private:
  class Sweeps;
  void require_contact(const Field& gap, Given normal, const ContactHistory& before) const;
  /// From the solution for the repulsion.
  PartialSlipSolution finished(PartialSlipSolution solution, Given normal,
                               const Attraction& attraction, const ContactSettings& settings) const;

  Grid grid_;
  FrictionLaw friction_;
  SharedContactLaw law_;
  double crosswise_;  // compliance
  Multilevel normal_;
  ShearSolver shear_;
  operators::NormalTangentialCoupling coupling_;
};

}  // namespace samcontact::contact
