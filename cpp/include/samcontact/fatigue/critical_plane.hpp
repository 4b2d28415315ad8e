// SPDX-License-Identifier: GPL-3.0-or-later
// Critical-plane fatigue criteria.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/fatigue/paths.hpp"

namespace samcontact::fatigue {

/// Maximum of a criterion over all planes, and the normal of the plane with this maximum.
struct CriticalPlane {
  Field value;   // [cell]
  Field normal;  // [3][cell], unit vectors
};

/// Findley: shear amplitude + k times the maximum normal stress of the cycle [Pa]. The amplitude is
/// the radius of the smallest circle around the path of the shear in the plane. W. N. Findley
/// (1959), J. Eng. Ind. 81, 301-305.
CriticalPlane findley(const Paths& stress, double k);

/// Fatemi and Socie: amplitude of the engineering shear strain times (1 + k times the maximum
/// normal stress), at least 0 [-]. shear: tensor shear strain, half the engineering strain, with
/// any mean; k: material constant divided by the yield stress [1/Pa]. Fatemi & Socie (1988),
/// doi:10.1111/j.1460-2695.1988.tb01169.x.
CriticalPlane fatemi_socie(const Paths& shear, const Paths& stress, double k);

}  // namespace samcontact::fatigue
