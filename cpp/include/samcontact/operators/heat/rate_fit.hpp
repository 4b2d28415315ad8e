// SPDX-License-Identifier: GPL-3.0-or-later
// Weights with which a few decaying exponentials represent the response to a pulse, from its
// Laplace transform.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

namespace samcontact::operators {

/// Ages at which a response is represented, and its slowest decay.
struct ResponseAges {
  double shortest, longest;
  double slowest;  // all singularities of the transform lie at s <= -slowest
  double tolerance;
};

/// A response is the sum of weights W_j exp(-rate_j t); W = imaginary part of `weights` F(s).
struct RateFit {
  std::vector<std::complex<double>> s;  // at which the transform F is required
  Eigen::MatrixXcd weights;             // [rate][s]
};

/// Fit whose errors are small compared with the growth of the response to a constant load in
/// proportion to t^power, 1 >= power > 0, until 1/rates[0].
RateFit fit_rates(std::span<const double> rates, const ResponseAges& ages, double power);

}  // namespace samcontact::operators
