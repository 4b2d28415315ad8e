// SPDX-License-Identifier: GPL-3.0-or-later
// Contact problem in terms of the repulsion: displacement and load due to attraction are subtracted
// first, so that all solvers require p >= 0.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"

namespace samcontact::contact {

/// Attraction as a constant traction. Keeps a reference to the gap.
class Attraction {
 public:
  /// gap: of the undeformed surfaces [i][j] [m]. Exact if the law does not depend on the gap.
  Attraction(const ContactLaw& law, const Grid& grid,
             const operators::NormalDisplacement& displacement, const Field& gap);
  /// pull: attraction of each cell [i][j] [Pa]; empty: none.
  Attraction(Field pull, const Grid& grid, const operators::NormalDisplacement& displacement,
             const Field& gap);

  /// Gap of the undeformed surfaces plus the displacement due to the attraction [m].
  const Field& gap() const { return pull_.empty() ? given_ : attracted_; }
  /// Load and moments plus those of the attraction; an approach and tilts are unchanged. Throws
  /// std::invalid_argument for a tension above the force of the attraction.
  Drive repelling(const Drive& drive) const;
  /// Repulsion of a pressure, which may be empty.
  Field repulsion(Field pressure) const;
  /// Solution of the contact with attraction, from the solution for the repulsion.
  Solution with_attraction(Solution solution, const Drive& drive) const;

 private:
  const Field& given_;
  Field pull_;  // [Pa]; empty: none
  Field attracted_;
  double cell_area_;
  double force_ = 0.0;  // [N]
  AboutAxes moment_{};  // [N m]
};

}  // namespace samcontact::contact
