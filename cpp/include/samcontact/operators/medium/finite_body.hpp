// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous body with free end faces across y: a medium under pressure only.
#pragma once

#include <optional>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/free_faces.hpp"
#include "samcontact/operators/medium/medium.hpp"
#include "samcontact/plasticity/body.hpp"

namespace samcontact::operators {

/// Body whose coefficients are those of the half-space, for pressure and u_z; EndEffects add the
/// effect of its faces. All other functions throw std::invalid_argument: stress, shear, heat and
/// residual displacement are not known near a free face.
SharedMedium finite_body(const Elastic& elastic, const FreeFaces& faces);

/// Elastic constants and faces of a finite body.
struct FacedBody {
  Elastic elastic = {};
  FreeFaces faces = {};
};

/// Faces of a medium made by finite_body(); none for any other medium.
std::optional<FacedBody> faced_body(const Medium& medium);

/// Medium of a body: finite_body() if its material has free faces, else medium_of() its stack.
SharedMedium medium_of(const plasticity::Body& body);

}  // namespace samcontact::operators
