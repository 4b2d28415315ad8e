// SPDX-License-Identifier: GPL-3.0-or-later
// Solution of one increment with partial slip and adhesion: at the attraction of the solution, the
// surfaces are in hard contact.
#pragma once

#include "samcontact/contact/partial_slip_contact.hpp"

namespace samcontact::contact {

class PartialSlipContact::AdhesiveSlip {
 public:
  AdhesiveSlip(const PartialSlipContact& contact, const Field& gap, const Drive& drive,
               const TangentialDrive& tangential, ContactHistory before,
               const ContactSettings& settings, const FrictionConditions& conditions);

  /// Coupled bodies interact through the normal displacement due to the shear, which is iterated
  /// until it equals that of the solution.
  PartialSlipSolution run(const PartialSlipStart& start);

 private:
  /// Repulsion and gap before the increment in place of the pressure.
  void find_repulsion_before();
  /// Normal displacement of the surfaces due to a shear; zero unless the bodies are coupled.
  Field raised_by(const Field& shear);
  /// Pressure and shear at the attraction and the approach of an adhesive contact.
  PartialSlipSolution slip_at(const Solution& adhesive, const PartialSlipStart& start);
  /// History with the slip due to the change of the attraction.
  ContactHistory history_at(const Field& pull);
  /// Bound of the shear of each cell, relative to that by the repulsion `pushed`; empty: 1.
  Field share_of_bound(const Field& pushed, const Field& gap) const;
  /// Whether a change of the displacement of the surfaces in contact is within the tolerance.
  bool is_small(const Field& change, const Solution& adhesive);

  const PartialSlipContact& contact_;
  const Field& gap_;
  const Drive& drive_;
  const TangentialDrive& tangential_;
  const ContactSettings& settings_;
  const FrictionConditions& conditions_;
  ContactHistory before_;
  Field pull_before_;  // empty: unknown
  ComplexField work_;
};

}  // namespace samcontact::contact
