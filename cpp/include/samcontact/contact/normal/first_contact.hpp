// SPDX-License-Identifier: GPL-3.0-or-later
// Newly contacting cells of an increment: the fraction of the slip that occurs after first contact.
#pragma once

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/surface/tangential_displacement.hpp"

namespace samcontact::contact {

/// Ratio of the tangential displacements under Fourier modes of shear across and along their
/// wavevector: 1/(1 - nu) [-].
double crosswise_compliance(const Grid& grid, const operators::TangentialInfluence& influence);

/// Increment in which the contact grows.
struct Growth {
  const Field& before;    // pressure [i][j] before the increment
  const Field& pressure;  // pressure at its end
  const Field& gap;       // gap before the increment [m]
  double closer;          // increment of the approach [m], > 0
  /// Rigid tangential motion if it is prescribed, and its upper limit for the shear [m].
  double slid, max_slid;
};

/// Symmetric matrices [xx, xy, yy][i][j]: the fraction of the rigid motion of an increment that
/// occurs while a cell is in contact. Rigid bodies that approach at constant speed close a gap
/// after the corresponding fraction of the increment. Elastic displacement changes the closed gap
/// and the previous slip by one factor across the edge of the contact and by another factor along
/// the edge; the factors of a growing round contact are used. Motions larger than the elastic
/// displacement due to shear do not change these factors. Empty if no cell comes into contact.
Field slip_after_contact(const Grid& grid, const Growth& growth, double crosswise);

}  // namespace samcontact::contact
