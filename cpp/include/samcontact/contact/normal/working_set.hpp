// SPDX-License-Identifier: GPL-3.0-or-later
// Set of cells stored as runs of neighbours, and the conjugate-gradient sweeps over it: few sweeps,
// which skip all other cells.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Sums over a set.
struct Sums {
  double plain = 0.0, product = 0.0;
};

/// Sums and extrema do not depend on the number of threads.
class CellRuns {
 public:
  /// Cells i with chosen[i] == value; all entries are 0 or 1.
  void assign(const std::vector<unsigned char>& chosen, bool value);

  std::size_t size() const { return size_; }

  /// sum of a_i, and of a_i b_i.
  Sums sums(const Field& a, const Field& b) const;
  /// t = beta t - (z - mean).
  void update_direction(double beta, const Field& z, double mean, Field& t) const;
  /// y += factor x. Returns the minimum of y - shift, at most 0.
  double add(double factor, const Field& x, Field& y, double shift) const;
  /// Minimum of y - shift, at most 0.
  double lowest(const Field& y, double shift) const;
  /// r = y - shift. Returns the maximum |r|.
  double subtract(const Field& y, double shift, Field& r) const;

  struct Run {
    std::size_t begin, end;
  };

 private:
  template <class Part>
  double extreme(const Part& part) const;

  std::vector<Run> runs_;
  std::vector<std::size_t> chunks_;  // first run of each chunk, and the number of runs
  std::size_t size_ = 0;
};

}  // namespace samcontact::contact
