// SPDX-License-Identifier: GPL-3.0-or-later
// Relaxation of a viscoelastic body with constant Poisson's ratio (generalised Maxwell model).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace samcontact {

/// Modulus over the instantaneous one after a step of strain: 1 - sum of shares + sum of shares
/// exp(-t / times). Without terms the body is elastic.
struct Relaxation {
  /// Sums of the shares up to this distance from 1 are a fluid: rounding.
  static constexpr double rounding = 1e-12;

  std::vector<double> times, shares;  // [s], increasing; [-]

  bool is_on() const { return !times.empty(); }
  std::size_t terms() const { return times.size(); }
  /// Share of the modulus that does not relax; 0 for a fluid.
  double long_time_share() const {
    double rest = 1.0;
    for (const double share : shares) rest -= share;
    return rest > rounding ? rest : 0.0;
  }
  bool operator==(const Relaxation&) const = default;
};

}  // namespace samcontact
