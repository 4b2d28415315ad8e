// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/errors.hpp"

#include <array>
#include <charconv>

namespace samcontact {

std::string to_text(double value) {
  std::array<char, 32> text{};
  char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return std::string(text.data(), end);
}

std::string to_short_text(double value, int digits) {
  std::array<char, 32> text{};
  char* const end = std::to_chars(text.data(), text.data() + text.size(), value,
                                  std::chars_format::general, digits)
                        .ptr;
  return std::string(text.data(), end);
}

void require(bool condition, const std::string& name, const std::string& allowed, double value,
             const std::string& remedy) {
  if (!condition) {
    throw std::invalid_argument(name + " must be " + allowed + ", got " + to_text(value) +
                                (remedy.empty() ? "" : ": " + remedy));
  }
}

void require_moderate(const std::string& name, double value, const std::string& unit) {
  require(value >= 1e-75 && value <= 1e75, name, "between 1e-75 and 1e75 " + unit, value);
}

}  // namespace samcontact
