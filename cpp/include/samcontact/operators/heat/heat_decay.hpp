// SPDX-License-Identifier: GPL-3.0-or-later
// Decay factors of the modes of a level over a time, and amplitudes after a constant flux over that
// time.
#pragma once

#include <vector>

#include "samcontact/operators/heat/heat_modes.hpp"

namespace samcontact::operators {

/// exp(-lambda x) and (1 - exp(-lambda x))/lambda, lambda = decay + s^2, as products of factors
/// that depend on the mode and on s.
class Decay {
 public:
  Decay(const HeatLevel& level, double x);
  Complex factor(std::size_t mode, std::size_t j) const { return modes_[mode] * s_[j]; }
  Complex integral(std::size_t mode, std::size_t j, Complex lambda) const {
    if (lambda == 0.0) return x_;
    return (grown_[mode] + modes_[mode] * grown_s_[j]) / lambda;
  }

 private:
  std::vector<Complex> modes_, grown_;
  std::vector<double> s_, grown_s_;
  double x_;
};

}  // namespace samcontact::operators
