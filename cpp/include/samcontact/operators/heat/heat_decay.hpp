// SPDX-License-Identifier: GPL-3.0-or-later
// Decay factors of the modes of a level over a time, amplitudes after a constant flux over that
// time, and phases due to motion.
#pragma once

#include <vector>

#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

/// exp(-lambda x) and (1 - exp(-lambda x))/lambda, lambda = decay + i w1 speed + rate, as products
/// of factors that depend on the mode and on the node.
class Decay {
 public:
  /// speed: additional speed along x and y [dx per unit of x].
  Decay(const HeatLevel& level, double x, const PlaneVector& speed = {});
  Complex factor(std::size_t mode, std::size_t node) const { return modes_[mode] * nodes_[node]; }
  /// rate: that of the node.
  Complex integral(std::size_t mode, std::size_t node, double rate) const {
    const Complex lambda = decay_[mode] + rate;
    if (lambda == 0.0) return x_;
    return (grown_[mode] + modes_[mode] * grown_nodes_[node]) / lambda;
  }

 private:
  std::vector<Complex> decay_, modes_, grown_;
  std::vector<double> nodes_, grown_nodes_;
  double x_;
};

/// Factors of the modes of a level due to a motion along x and y [dx].
ComplexField phases_of(const HeatLevel& level, const PlaneVector& motion);

}  // namespace samcontact::operators
