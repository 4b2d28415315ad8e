// SPDX-License-Identifier: GPL-3.0-or-later
// Normal contact laws: attraction as a function of the gap, and the test of whether a cell is in
// contact. No other code compares a pressure with zero.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Whether a cell is in contact, by its repulsion [Pa].
inline bool in_contact(double repulsion) { return repulsion > 0; }

/// Law of the pressure p = r - a(g), with a repulsion r >= 0, r g = 0, on closed cells and an
/// attraction a(g) >= 0 across the gap g >= 0; the pressure is bounded by p >= -a(g).
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// Attraction a(g) [Pa]; 0 at an infinite gap (no body).
  virtual double attraction(double gap) const = 0;
  /// Maximum of the attraction a(g) [Pa].
  virtual double largest_attraction() const = 0;
  /// Decrease of the attraction per distance, -a'(g) [Pa/m].
  virtual double fall(double /*gap*/) const { return 0.0; }
  /// Maximum of the fall [Pa/m]; 0 if the attraction does not depend on the gap.
  virtual double steepest_fall() const { return 0.0; }
  /// Gap beyond which the attraction is negligible [m]; infinite if there is none.
  virtual double reach() const { return std::numeric_limits<double>::infinity(); }
  /// Work against the attraction from closed to a gap, the integral of a(g) [J/m^2]; 0 at an
  /// infinite gap.
  virtual double energy(double gap) const = 0;

  /// Whether friction depends on the pressure p where it is positive, and not on the repulsion r.
  virtual bool rubs_by_compression() const { return false; }

  bool attracts() const { return largest_attraction() > 0; }
  /// Whether the attraction depends on the gap: the contact may then have several solutions.
  bool varies() const { return steepest_fall() > 0; }

 protected:
  ContactLaw() = default;
  ContactLaw(const ContactLaw&) = default;
  ContactLaw(ContactLaw&&) = default;
  ContactLaw& operator=(const ContactLaw&) = default;
  ContactLaw& operator=(ContactLaw&&) = default;
};

using SharedContactLaw = std::shared_ptr<const ContactLaw>;

/// Law without attraction: p >= 0.
class HardContact final : public ContactLaw {
 public:
  double attraction(double /*gap*/) const override { return 0.0; }
  double largest_attraction() const override { return 0.0; }
  double energy(double /*gap*/) const override { return 0.0; }
};

SharedContactLaw hard_contact();

/// Contact law by name. Throws std::invalid_argument for an unknown name and for parameters out of
/// range.
SharedContactLaw contact_law(const std::string& kind, const std::vector<double>& parameters);

/// The same law, with friction that depends on the compressive part of the pressure.
SharedContactLaw rubbing_by_compression(SharedContactLaw law);

/// Attraction at each gap [Pa].
Field attraction(const ContactLaw& law, const Field& gap);

/// Pressure plus the attraction at the gap [Pa]; the gap is not read if the law has no attraction.
/// If the attraction depends on the gap, a repulsion below the error of the pressure is zero.
Field repulsion(const ContactLaw& law, Field pressure, const Field& gap);

/// Pressure on which the friction of each cell depends [Pa], >= 0: the repulsion (Derjaguin), or
/// the compressive part of the pressure of cells in contact. pushed: repulsion.
Field rubbing_pressure(const ContactLaw& law, Field pushed, const Field& gap);

}  // namespace samcontact::contact
