// SPDX-License-Identifier: GPL-3.0-or-later
// A contact in terms of its repulsion: what attraction displaces and bears is taken off first, so
// that all solvers ask for p >= 0.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/complementarity.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"

namespace samcontact::contact {

/// The attraction at given gaps, as a traction that does not change. Exact where the law does not
/// depend on the gap. Holds a reference to the gap.
class Attraction {
 public:
  Attraction(const ContactLaw& law, const Grid& grid,
             const operators::NormalDisplacement& displacement, const Field& gap);

  /// The gap of the undeformed surfaces with the displacement due to the attraction [m].
  const Field& gap() const { return pull_.empty() ? given_ : attracted_; }
  /// A load with the force of the attraction; an approach as it is. Throws std::invalid_argument
  /// for a tension beyond that force.
  Given normal(const Given& normal) const;
  /// Of a pressure, which may be empty.
  Field repulsion(Field pressure) const;
  /// The solution of a contact driven so, from that for the repulsion.
  Solution with_attraction(Solution solution, const Given& normal) const;

 private:
  const Field& given_;
  Field pull_;  // [Pa]; empty: none
  Field attracted_;
  double cell_area_;
  double force_ = 0.0;  // [N]
};

}  // namespace samcontact::contact
