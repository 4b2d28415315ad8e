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
  /// across_x, across_y: of which sides there is too little.
  GridTooSmallError(const std::string& what, bool across_x, bool across_y)
      : std::invalid_argument(what), across_x_(across_x), across_y_(across_y) {}
  bool across_x() const { return across_x_; }
  bool across_y() const { return across_y_; }

 private:
  bool across_x_, across_y_;
};

/// Shortest decimal text that reads back as the same double.
std::string to_text(double value);
/// The same with so many significant digits at most.
std::string to_short_text(double value, int digits = 3);

/// Throws std::invalid_argument "NAME must be ALLOWED, got VALUE" unless `condition` holds.
void require(bool condition, const std::string& name, const std::string& allowed, double value,
             const std::string& remedy = {});

/// Throws unless 1e-75 <= value <= 1e75: squares and products must be numbers.
void require_moderate(const std::string& name, double value, const std::string& unit);

}  // namespace samcontact
