// SPDX-License-Identifier: GPL-3.0-or-later
// What loads a surface, pressure and shear along x and y, and the axes it moves along.
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

/// Of a traction, and of the displacement that it works on, as a component of a vector in the
/// mirrors x = 0 and y = 0.
constexpr kernels::Parity vector_parity(Traction traction) {
  return {traction == Traction::shear_x, traction == Traction::shear_y, false};
}

/// The traction that works on a displacement along an axis.
constexpr Traction traction_along(Axis axis) {
  if (axis == Axis::z) return Traction::pressure;
  return axis == Axis::x ? Traction::shear_x : Traction::shear_y;
}

/// The reverse.
constexpr Axis axis_along(Traction traction) {
  if (traction == Traction::pressure) return Axis::z;
  return traction == Traction::shear_x ? Axis::x : Axis::y;
}

/// Tractions on a surface [i][j] [Pa] in the body's own frame; empty arrays mean none.
struct Tractions {
  Field pressure, shear_x, shear_y;

  bool operator==(const Tractions&) const = default;
  const Field& of(Traction kind) const {
    return kind == Traction::pressure ? pressure : kind == Traction::shear_x ? shear_x : shear_y;
  }
};

/// Shear acts on body 2 (index 1) as it is given and on body 1 (index 0) in the opposite direction.
constexpr double shear_sign(int body) { return body == 1 ? 1.0 : -1.0; }

/// What a traction is multiplied by.
constexpr double sign_of(Traction kind, double shear_sign) {
  return kind == Traction::pressure ? 1.0 : shear_sign;
}

}  // namespace samcontact::operators
