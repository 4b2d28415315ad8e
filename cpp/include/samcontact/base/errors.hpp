// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of failure that callers tell apart, and the checks that raise them.
#pragma once

#include <stdexcept>
#include <string>

namespace samcontact {

/// An iteration did not reach its tolerance; the state before the call is intact.
class ConvergenceError : public std::runtime_error {
 public:
  ConvergenceError(const std::string& what, int iterations, double residual)
      : std::runtime_error(what), iterations_(iterations), residual_(residual) {}
  int iterations() const { return iterations_; }
  double residual() const { return residual_; }

 private:
  int iterations_;
  double residual_;
};

/// The contact needs more room than the grid has.
class GridTooSmallError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Shortest decimal text that reads back as the same double.
std::string to_text(double value);
/// The same with three significant digits.
std::string to_short_text(double value);

/// Throws std::invalid_argument "NAME must be ALLOWED, got VALUE" unless `condition` holds.
void require(bool condition, const std::string& name, const std::string& allowed, double value);

/// Throws unless 1e-75 <= value <= 1e75: squares and products must be numbers.
void require_moderate(const std::string& name, double value, const std::string& unit);

}  // namespace samcontact
