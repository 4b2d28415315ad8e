// SPDX-License-Identifier: GPL-3.0-or-later
// What is given of a contact, and what moves in answer.
#pragma once

#include <string>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {

/// One degree of freedom of the bodies' rigid motion: the motion itself, or the force that brings
/// it about.
struct Given {
  enum class Kind { motion, force } kind;
  double value;  // [m] or [N]

  static constexpr Given motion(double metre) { return {Kind::motion, metre}; }
  static constexpr Given force(double newton) { return {Kind::force, newton}; }
  bool is_force() const { return kind == Kind::force; }
};

/// Of body 1 against body 2, since they touched undeformed.
struct RigidMotion {
  double approach = 0.0;  // [m]
};

/// What drives a contact: each degree of freedom that the law of the contact leaves open. Gross
/// sliding leaves the normal one.
struct Drive {
  Given normal;

  static Drive load(double newton) { return {Given::force(newton)}; }
  static Drive approach(double metre) { return {Given::motion(metre)}; }
};

/// For messages.
std::string describe(const Drive& drive);

/// Throws std::invalid_argument, naming the argument, unless a contact of this law can be driven
/// so: loads below zero need an attraction.
void require_valid(const Drive& drive, const ContactLaw& law);
/// Throws std::invalid_argument unless a surface field has the shape of the grid and is finite.
void require_surface(const Field& field, const Grid& grid, const std::string& name);
/// The same of a gap, which is +inf in cells without a body, finite in at least one.
void require_gap(const Field& gap, const Grid& grid, const std::string& name);

}  // namespace samcontact::contact
