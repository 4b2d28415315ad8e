// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for the contact of two elastic bodies: from a drive to tractions and a rigid-body motion.
#pragma once

#include <memory>
#include <string>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/adhesive_contact.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/multilevel.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::contact {

/// Action if the contact reaches the edge of the grid.
enum class OnBorder { error, warn };

/// Message that names the edges of the grid reached by the contact and the remedy, from the
/// repulsion; empty if the contact is inside the grid. what: text that describes the drive.
std::string edge_warning(const Grid& grid, const Field& repulsion, const std::string& what);
/// Error with the message of edge_warning(), which also names the option for a warning instead.
GridTooSmallError too_small(const Grid& grid, const Field& repulsion, const std::string& warning);

/// Throws std::invalid_argument if both bodies are rigid.
void require_deformable(bool any);
/// Throws std::invalid_argument unless the contact law allows the drive between these surfaces;
/// an approach at which periodic surfaces touch everywhere is not allowed.
void require_possible(const Grid& grid, const ContactLaw& law, const Field& gap,
                      const Drive& drive);

/// Action if the sweeps between pressure and shear of dissimilar materials stall: an error (fail);
/// a solution for both together, and an error if it does not converge (join), or instead of this
/// error the state with the smallest error and a warning (accept).
enum class AfterStall { fail, join, accept };

struct ContactSettings {
  double tol = 1e-8;
  int max_iterations = 5000;  // of the pressure, and Newton steps on pressure and shear together
  OnBorder on_border = OnBorder::error;
  AfterStall after_stall = AfterStall::join;
};

/// Throws std::invalid_argument for input or settings with which a contact cannot be solved.
void require_solvable(const Grid& grid, const ContactLaw& law, const Field& gap, const Drive& drive,
                      const Field& initial_pressure, const ContactSettings& settings);

class ContactSolver {
 public:
  /// friction: full sliding. heating: of the two bodies. Friction and its heat are proportional to
  /// the repulsion. Throws std::invalid_argument if both bodies are rigid, a rigid body is heated,
  /// or surfaces with attraction are heated.
  ContactSolver(const Grid& grid, const operators::SharedMedium& body1,
                const operators::SharedMedium& body2, const FrictionLaw& friction,
                const operators::HeatingPair& heating = {}, SharedContactLaw law = hard_contact());

  /// If the displacement is an even operator (stationary heat included), a single solve of the
  /// complementarity problem. Odd contributions (friction of dissimilar materials, moving heat) are
  /// lagged in an outer fixed-point iteration: for friction a contraction with a factor <= mu (1 -
  /// 2 nu)/(2 (1 - nu)), in the energy norm the largest ratio of the operators' Fourier symbols.
  /// initial_pressure may be empty. Throws std::invalid_argument (a load below the minimum of the
  /// contact law, wrong shape, not finite), GridTooSmallError and ConvergenceError.
  Solution solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                 const ContactSettings& settings) const;

  const Grid& grid() const { return grid_; }
  const FrictionLaw& friction() const { return friction_; }
  const ContactLaw& law() const { return *law_; }

 private:
  ContactSolver(const Grid& grid, const operators::SurfaceInfluence& influence,
                FrictionLaw friction, SharedContactLaw law);
  /// Whether the thermal expansion due to a uniform pressure on the contact exceeds, on average,
  /// its elastic compression.
  bool is_unstable(const Field& pressure) const;
  /// Throws ConvergenceError unless the solution has converged.
  void require_solved(const Solution& solution, const Drive& drive,
                      const ContactSettings& settings) const;
  Solution solve_coupled(const Field& gap, const Drive& drive, Field pressure,
                         const ContactSettings& settings) const;
  /// With attraction that depends on the gap.
  Solution solve_adhesive(const Field& gap, const Drive& drive, const Field& initial_pressure,
                          const ContactSettings& settings) const;

  Grid grid_;
  FrictionLaw friction_;
  SharedContactLaw law_;
  bool heated_;
  Multilevel multilevel_;
  std::unique_ptr<const AdhesiveContact> adhesive_;  // null: the law does not vary with the gap
};

}  // namespace samcontact::contact
