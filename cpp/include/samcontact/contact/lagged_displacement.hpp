// SPDX-License-Identifier: GPL-3.0-or-later
// Contact with a part of the displacement that depends on the pressure but is taken from the
// previous solution.
#pragma once

#include <functional>

#include "samcontact/contact/normal/complementarity.hpp"

namespace samcontact::contact {

/// The two functions of such a contact.
struct LaggedContact {
  /// Replaces a field by the lagged part of the separation due to a pressure [i][j] [m].
  std::function<void(const Field& pressure, Field& separation)> separate;
  /// Solution for a gap that contains the lagged part, from an initial pressure, to a tolerance.
  std::function<Solution(const Field& gap, Field pressure, double tol)> solve;
};

/// Repeats the solution until the lagged part equals that of its own pressure; slow iterations are
/// accelerated. The error of the solution contains the change of the lagged part in the contact,
/// relative to the largest other displacement.
Solution solve_lagged(const LaggedContact& contact, const Grid& grid, const Field& gap,
                      const Drive& drive, Field pressure, double tol);

}  // namespace samcontact::contact
