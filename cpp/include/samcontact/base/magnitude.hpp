// SPDX-License-Identifier: GPL-3.0-or-later
// Magnitude of the numbers of an array, for checks of input.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace samcontact {

struct Magnitude {
  double largest = 0.0;   // of the finite numbers
  bool is_finite = true;  // whether all numbers are finite
};

/// Largest magnitude of the finite numbers, and whether all numbers are finite.
inline Magnitude magnitude_of(std::span<const double> numbers) {
  Magnitude found;
  for (const double number : numbers) {
    const double size = std::fabs(number);
    const bool is_finite = size <= std::numeric_limits<double>::max();
    found.largest = std::max(found.largest, is_finite ? size : 0.0);
    found.is_finite &= is_finite;
  }
  return found;
}

}  // namespace samcontact
