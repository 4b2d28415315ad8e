// SPDX-License-Identifier: GPL-3.0-or-later
// Solver for the normal elastic contact: start from coarser grids, active-set iteration with an
// approximate operator, and an outer iteration with the exact operator, which corrects and checks
// the result.
#pragma once

#include <memory>

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/contact/normal/rigid_modes.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"

namespace samcontact::contact {

/// Solves p >= 0, g >= 0, p g = 0 on one grid, for any number of gaps and drives. Keeps the exact
/// operator of the grid and, after first use, the operators of coarser grids and the approximate
/// operators. Thread-safe.
class Multilevel {
 public:
  Multilevel(const Grid& grid, const operators::SurfaceInfluence& influence);
  ~Multilevel();
  Multilevel(Multilevel&&) noexcept;
  Multilevel& operator=(Multilevel&&) noexcept;
  Multilevel(const Multilevel&) = delete;
  Multilevel& operator=(const Multilevel&) = delete;

  /// Exact operator of the grid.
  const operators::SurfaceDisplacement& displacement() const;

  /// Starts from `pressure`, or from a coarser grid if that is zero everywhere. Returns converged =
  /// false after max_iterations. Cells of infinite gap (no body) stay out of contact.
  Solution solve(const Field& initial_gap, const Drive& drive, Field pressure, double tol,
                 int max_iterations) const;

 private:
  class Level;

  Solution solve_with_ends(const Field& initial_gap, const RigidModes& modes, Field pressure,
                           double tol, int max_iterations) const;

  std::unique_ptr<Level> finest_;
};

}  // namespace samcontact::contact
