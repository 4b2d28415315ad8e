// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of two elastic bodies: takes a drive, returns tractions and a rigid motion.
#pragma once

#include <string>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/multilevel.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::contact {

/// What to do when the contact reaches the border of the grid.
enum class OnBorder { error, warn };

/// Names the border that the contact touches and the remedy, from its repulsion; empty when it
/// touches none. what: the drive in words.
std::string border_complaint(const Grid& grid, const Field& repulsion, const std::string& what);
/// The error of such a complaint, which also names the way to a warning.
GridTooSmallError too_small(const Grid& grid, const Field& repulsion, const std::string& complaint);

/// Throws std::invalid_argument for an approach at which periodic surfaces touch everywhere.
void require_below_mean(const Grid& grid, const Field& gap, Given normal);

struct ContactSettings {
  double tol = 1e-8;
  int max_iterations = 5000;
  OnBorder on_border = OnBorder::error;
};

class ContactSolver {
 public:
  /// friction: gross sliding. heating: of the two bodies; friction, and the heat of it, go with the
  /// repulsion. Throws std::invalid_argument when both bodies are rigid, a rigid one is heated, or
  /// bodies that attract each other are.
  ContactSolver(const Grid& grid, const operators::SharedMedium& body1,
                const operators::SharedMedium& body2, const FrictionLaw& friction,
                const operators::HeatingPair& heating = {}, SharedContactLaw law = hard_contact());

  /// Where the displacement is an even operator (heat at rest included) one solve of the
  /// complementarity problem. What is not even (friction of dissimilar bodies, moving heat) is
  /// lagged in an outer fixed point: for friction a contraction with factor <= mu (1 - 2 nu)/(2 (1
  /// - nu)), in the energy norm the largest ratio of the operators' Fourier symbols.
  /// initial_pressure may be empty. Throws std::invalid_argument (a load below what the law bears,
  /// wrong shape, not finite), GridTooSmallError, and ConvergenceError.
  Solution solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                 const ContactSettings& settings) const;

  const Grid& grid() const { return grid_; }
  const FrictionLaw& friction() const { return friction_; }
  const ContactLaw& law() const { return *law_; }

 private:
  ContactSolver(const Grid& grid, const operators::SurfaceInfluence& influence,
                const FrictionLaw& friction, SharedContactLaw law);
  /// Whether a uniform pressure on the contact raises it, on the mean, more than it lowers it.
  bool is_unstable(const Field& pressure) const;
  /// Throws ConvergenceError otherwise.
  void require_solved(const Solution& solution, const Drive& drive,
                      const ContactSettings& settings) const;
  Solution solve_coupled(const Field& gap, Given normal, Field pressure,
                         const ContactSettings& settings) const;

  Grid grid_;
  FrictionLaw friction_;
  SharedContactLaw law_;
  bool heated_;
  Multilevel multilevel_;
};

}  // namespace samcontact::contact
