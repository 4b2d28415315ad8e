// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed quantities of a contact (load or approach), and the resulting rigid-body motion.
#pragma once

#include <string>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {

/// One degree of freedom of the rigid-body motion: the motion itself, or the corresponding force.
struct Given {
  enum class Kind { motion, force } kind;
  double value;  // [m] or [N]

  static constexpr Given motion(double metre) { return {Kind::motion, metre}; }
  static constexpr Given force(double newton) { return {Kind::force, newton}; }
  bool is_force() const { return kind == Kind::force; }
};

/// Motion of body 1 relative to body 2 since the undeformed bodies touched.
struct RigidMotion {
  double approach = 0.0;  // [m]
};

/// Prescribed values of all degrees of freedom that the contact law leaves open. Full sliding
/// leaves only the normal one.
struct Drive {
  Given normal;

  static Drive load(double newton) { return {Given::force(newton)}; }
  static Drive approach(double metre) { return {Given::motion(metre)}; }
};

/// Text that describes the drive, for messages.
std::string describe(const Drive& drive);

/// Throws std::invalid_argument with the name of the argument if the drive is not possible with
/// this contact law: negative loads require an attraction.
void require_valid(const Drive& drive, const ContactLaw& law);
/// Throws std::invalid_argument unless a surface field has the shape of the grid and is finite.
void require_surface(const Field& field, const Grid& grid, const std::string& name);
/// Throws std::invalid_argument unless a gap has the shape of the grid and is finite in at least
/// one cell, and finite or +inf (no body) in all others.
void require_gap(const Field& gap, const Grid& grid, const std::string& name);

}  // namespace samcontact::contact
