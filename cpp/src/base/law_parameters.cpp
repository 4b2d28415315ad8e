// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/law_parameters.hpp"

#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact {
namespace {

std::string text(const Allowed& allowed) {
  if (std::isfinite(allowed.high)) {
    return "in [" + to_text(allowed.low) + ", " + to_text(allowed.high) + "]";
  }
  const std::string unit = allowed.unit, sign = allowed.above_low ? " > " : " >= ";
  const std::string limit = sign + to_text(allowed.low) + (unit.empty() ? "" : " [" + unit + "]");
  if (allowed.infinite == nullptr) return "a finite number" + limit;
  return "a number" + limit + ", or inf (" + allowed.infinite + ")";
}

}  // namespace

void require_allowed(const std::string& name, double value, const Allowed& allowed) {
  const bool inside = allowed.above_low ? value > allowed.low : value >= allowed.low;
  const bool possible = std::isfinite(value) || allowed.infinite != nullptr;
  require(possible && inside && value <= allowed.high, name, text(allowed), value);
}

std::invalid_argument unknown_law(const std::string& what, const std::vector<std::string>& names,
                                  const std::string& name) {
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "'" : ", '") + known + "'";
  return std::invalid_argument(what + " must be one of " + list + ", got '" + name + "'");
}

std::string entry(const std::string& name, std::size_t n) {
  return name + '[' + std::to_string(n) + ']';
}

void require_allowed(const std::string& name, const std::vector<double>& values,
                     const Allowed& allowed) {
  for (std::size_t n = 0; n < values.size(); ++n) {
    require_allowed(entry(name, n), values[n], allowed);
  }
}

}  // namespace samcontact
