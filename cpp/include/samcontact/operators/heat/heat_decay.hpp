// SPDX-License-Identifier: GPL-3.0-or-later
// Decay factors of the modes of a level over a time, amplitudes after a constant flux over that
// time, and phases due to motion.
#pragma once

#include <vector>

#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

/// exp(-lambda x) and (1 - exp(-lambda x))/lambda, lambda = decay + i w1 speed + s^2, as products
/// of factors that depend on the mode and on s.
class Decay {
 public:
  /// speed: additional speed along x [dx per unit of x].
  Decay(const HeatLevel& level, double x, double speed = 0.0);
  Complex factor(std::size_t mode, std::size_t j) const { return modes_[mode] * s_[j]; }
  /// s2: s^2 of node j.
  Complex integral(std::size_t mode, std::size_t j, double s2) const {
    const Complex lambda = decay_[mode] + s2;
    if (lambda == 0.0) return x_;
    return (grown_[mode] + modes_[mode] * grown_s_[j]) / lambda;
  }

 private:
  std::vector<Complex> decay_, modes_, grown_;
  std::vector<double> s_, grown_s_;
  double x_;
};

/// Factors of the modes of a level due to a motion by some cells along x.
ComplexField phases_of(const HeatLevel& level, double cells);

}  // namespace samcontact::operators
