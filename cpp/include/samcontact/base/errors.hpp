// SPDX-License-Identifier: GPL-3.0-or-later
// Error classes that callers distinguish, and the checks that throw them.
#pragma once

#include <stdexcept>
#include <string>

namespace samcontact {

/// Error if an iteration does not reach its tolerance; the previous state is intact.
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

/// Error if an iteration stalls whose increment may be solved by another method.
class StalledError : public ConvergenceError {
 public:
  using ConvergenceError::ConvergenceError;
};

/// Error if the tension of a load exceeds the largest tension that adhesion allows.
class PullOffError : public ConvergenceError {
 public:
  PullOffError(const std::string& what, int iterations, double force, double approach)
      : ConvergenceError(what, iterations, 0.0), force_(force), approach_(approach) {}
  /// Largest tension reached [N], and its approach [m].
  double force() const { return force_; }
  double approach() const { return approach_; }

 private:
  double force_, approach_;
};

/// Error if a contact does not fit into the grid.
class GridTooSmallError : public std::invalid_argument {
 public:
  /// across_x, across_y: directions in which the grid is too small.
  GridTooSmallError(const std::string& what, bool across_x, bool across_y)
      : std::invalid_argument(what), across_x_(across_x), across_y_(across_y) {}
  bool across_x() const { return across_x_; }
  bool across_y() const { return across_y_; }

 private:
  bool across_x_, across_y_;
};

/// Shortest decimal text of a double from which the same double is read.
std::string to_text(double value);
/// Shortest decimal text of a number with at most the given number of significant digits.
std::string to_short_text(double value, int digits = 3);

/// Throws std::invalid_argument "NAME must be ALLOWED, got VALUE: REMEDY" unless `condition` holds.
void require(bool condition, const std::string& name, const std::string& allowed, double value,
             const std::string& remedy = {});

/// Throws std::invalid_argument unless 1e-75 <= value <= 1e75, so that squares and products are
/// finite.
void require_moderate(const std::string& name, double value, const std::string& unit);

}  // namespace samcontact
