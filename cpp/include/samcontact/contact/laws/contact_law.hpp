// SPDX-License-Identifier: GPL-3.0-or-later
// The law of contact across the surface: how far the pressure may fall at a gap, and which cells
// are in contact. Nothing else compares a pressure with zero.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Whether a cell is in contact, from its repulsion [Pa].
inline bool in_contact(double repulsion) { return repulsion > 0; }

/// Pressure p = r - a(g) of a repulsion r >= 0, r g = 0, on closed cells and an attraction a(g) >=
/// 0 across the gap g >= 0: p >= -a(g) is the bound of the pressure.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// a(g) [Pa]; 0 where there is no body, at an infinite gap.
  virtual double attraction(double gap) const = 0;
  /// The largest a(g) [Pa].
  virtual double largest_attraction() const = 0;
  /// Work against attraction from closed to a gap, the integral of a(g) [J/m^2]; 0 where there is
  /// no body.
  virtual double energy(double gap) const = 0;

  bool attracts() const { return largest_attraction() > 0; }

 protected:
  ContactLaw() = default;
  ContactLaw(const ContactLaw&) = default;
  ContactLaw(ContactLaw&&) = default;
  ContactLaw& operator=(const ContactLaw&) = default;
  ContactLaw& operator=(ContactLaw&&) = default;
};

using SharedContactLaw = std::shared_ptr<const ContactLaw>;

/// p >= 0: surfaces do not attract each other.
class HardContact final : public ContactLaw {
 public:
  double attraction(double /*gap*/) const override { return 0.0; }
  double largest_attraction() const override { return 0.0; }
  double energy(double /*gap*/) const override { return 0.0; }
};

SharedContactLaw hard_contact();

/// The law of a name. Throws std::invalid_argument for an unknown one and for parameters out of
/// range.
SharedContactLaw contact_law(const std::string& kind, const std::vector<double>& parameters);

/// Attraction at each gap [Pa].
Field attraction(const ContactLaw& law, const Field& gap);

/// What is left of a pressure beside the attraction at the gap [Pa]; the gap is not read where the
/// law has none.
Field repulsion(const ContactLaw& law, Field pressure, const Field& gap);

}  // namespace samcontact::contact
