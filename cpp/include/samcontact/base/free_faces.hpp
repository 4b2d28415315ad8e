// SPDX-License-Identifier: GPL-3.0-or-later
// Free end faces of a body, across the y axis.
#pragma once

#include <limits>

namespace samcontact {

/// Model of a free face: the quarter space, or its pressure-independent approximation by one factor
/// on the mirrored load.
enum class FaceMethod { exact, factor };

/// The body occupies low < y < high; both faces are perpendicular to y and free of traction.
struct FreeFaces {
  double low = -std::numeric_limits<double>::infinity();  // [m]; -infinity: no face
  double high = std::numeric_limits<double>::infinity();  // [m]; infinity: no face
  FaceMethod method = FaceMethod::exact;

  bool has_low() const { return low > -std::numeric_limits<double>::infinity(); }
  bool has_high() const { return high < std::numeric_limits<double>::infinity(); }
  bool any() const { return has_low() || has_high(); }
  bool operator==(const FreeFaces&) const = default;
};

}  // namespace samcontact
