// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for the contact of viscoelastic bodies in steady rolling or sliding without friction.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/surface/creeping_displacement.hpp"

namespace samcontact::contact {

/// Keeps the operators of the grid and, after first use, those of coarser grids. Thread-safe.
class CreepingContact {
 public:
  /// Throws std::invalid_argument if both bodies are rigid.
  CreepingContact(const Grid& grid, std::vector<operators::CreepingBody> bodies);
  ~CreepingContact();
  CreepingContact(CreepingContact&&) noexcept;
  CreepingContact& operator=(CreepingContact&&) noexcept;
  CreepingContact(const CreepingContact&) = delete;
  CreepingContact& operator=(const CreepingContact&) = delete;

  /// Steady state for a load or an approach, without tilts. The start comes from coarser grids if
  /// initial_pressure is empty. Throws std::invalid_argument, GridTooSmallError and
  /// ConvergenceError, as ContactSolver::solve() does.
  Solution solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                 const ContactSettings& settings) const;

  /// Displacement that closes the gap [i][j] [m] due to a pressure [i][j] [Pa].
  Field displacement(const Field& pressure) const;

  const Grid& grid() const { return grid_; }
  const ContactLaw& law() const { return *law_; }

 private:
  class Level;

  Grid grid_;
  SharedContactLaw law_;
  std::unique_ptr<Level> finest_;
};

}  // namespace samcontact::contact
