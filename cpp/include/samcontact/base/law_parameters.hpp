// SPDX-License-Identifier: GPL-3.0-or-later
// Allowed values of the parameters of a law, as declared by its struct.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace samcontact {

/// Allowed range of a parameter: low <= value <= high, or low < value. The value must be finite
/// unless the range allows infinity.
struct Allowed {
  const char* unit;  // "" for a plain number
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  bool above_low = false;
  const char* infinite = nullptr;  // meaning of an infinite value; null: the value must be finite

  static constexpr Allowed positive(const char* unit) { return {.unit = unit, .above_low = true}; }
};

/// Parameter of a law that is created by name.
struct LawParameter {
  std::string name;
  Allowed allowed;
  bool many = false;  // a list of such numbers
};

/// Throws std::invalid_argument with the name of the parameter, its value and the allowed range.
void require_allowed(const std::string& name, double value, const Allowed& allowed);
/// Checks each value; the message names name[n].
void require_allowed(const std::string& name, const std::vector<double>& values,
                     const Allowed& allowed);
/// "name[n]".
std::string entry(const std::string& name, std::size_t n);

/// Calls `function` with each alternative of a variant, without values.
template <class Laws, class Function>
void for_each_law(const Function& function) {
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    (function(std::variant_alternative_t<n, Laws>{}), ...);
  }(std::make_index_sequence<std::variant_size_v<Laws>>{});
}

}  // namespace samcontact
