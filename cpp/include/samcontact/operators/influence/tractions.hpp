// SPDX-License-Identifier: GPL-3.0-or-later
// Tractions on a surface (pressure, shear along x and y), and axes of its displacement.
#pragma once

#include <array>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

enum class Traction { pressure, shear_x, shear_y };
inline constexpr std::array all_tractions{Traction::pressure, Traction::shear_x, Traction::shear_y};

enum class Axis { x, y, z };
inline constexpr std::array all_axes{Axis::x, Axis::y, Axis::z};
inline constexpr std::array normal_axis{Axis::z};

/// Parity of a traction, and of the work-conjugate displacement, as a component of a vector in the
/// mirrors x = 0 and y = 0.
constexpr kernels::Parity vector_parity(Traction traction) {
  return {traction == Traction::shear_x, traction == Traction::shear_y, false};
}

/// Traction that is work-conjugate to a displacement along an axis.
constexpr Traction traction_along(Axis axis) {
  if (axis == Axis::z) return Traction::pressure;
  return axis == Axis::x ? Traction::shear_x : Traction::shear_y;
}

/// Axis of the work-conjugate displacement of a traction.
constexpr Axis axis_along(Traction traction) {
  if (traction == Traction::pressure) return Axis::z;
  return traction == Traction::shear_x ? Axis::x : Axis::y;
}

/// Tractions on the surface of a body [i][j] [Pa] in the frame of the body; empty arrays: zero.
struct Tractions {
  Field pressure, shear_x, shear_y;

  bool operator==(const Tractions&) const = default;
  const Field& of(Traction kind) const {
    return kind == Traction::pressure ? pressure : kind == Traction::shear_x ? shear_x : shear_y;
  }
};

/// Shear acts on body 2 (index 1) as given and on body 1 (index 0) in the opposite direction.
constexpr double shear_sign(int body) { return body == 1 ? 1.0 : -1.0; }

/// Factor of a traction on a body.
constexpr double sign_of(Traction kind, double shear_sign) {
  return kind == Traction::pressure ? 1.0 : shear_sign;
}

}  // namespace samcontact::operators
