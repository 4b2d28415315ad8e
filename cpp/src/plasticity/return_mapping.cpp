// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/plasticity/return_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace samcontact::plasticity {
namespace {

double equivalent(const Tensor& deviator) {
  const Tensor& s = deviator;
  return std::sqrt(1.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) +
                   3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Tensor deviator(const Tensor& stress) {
  const double mean = (stress[0] + stress[1] + stress[2]) / 3;
  return {stress[0] - mean, stress[1] - mean, stress[2] - mean, stress[3], stress[4], stress[5]};
}

}  // namespace

double von_mises(const Tensor& stress) { return equivalent(deviator(stress)); }

double equivalent_increment(double trial, double g, double shear_modulus,
                            const Hardening& hardening, double start) {
  const double stiffness = 3 * shear_modulus;
  if (trial <= hardening.yield_stress(g)) return 0.0;
  // The yield stress is concave in g: from an estimate that is too large Newton's first iterate is
  // too small, and from there they rise monotonically to the root.
  double d = start;
  for (int n = 0; n < 100; ++n) {
    const auto [yield_stress, slope] = hardening.at(g + d);
    const double step = (trial - stiffness * d - yield_stress) / (stiffness + slope);
    if (step < 0 && n > 0) break;
    d = std::max(0.0, d + step);
    // The next step would be of the order of this one squared.
    if (std::fabs(step) <= 1e-8 * d) break;
  }
  return d;
}

Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const Hardening& hardening) {
  const Tensor s = deviator(stress);
  Tensor trial = s;
  for (int c = 0; c < 6; ++c) trial[c] += 2 * shear_modulus * guess[c];
  const double q = equivalent(trial), yield_before = hardening.yield_stress(g);
  Return result{};
  double yield = yield_before;
  if (q > yield_before) {
    // For a plastic strain sqrt(2/3 e:e) is 2/3 of what `equivalent` makes of it.
    const double estimate = 2.0 / 3 * equivalent(guess);
    result.equivalent = equivalent_increment(q, g, shear_modulus, hardening, estimate);
    const double scale = 1.5 * result.equivalent / q;
    for (int c = 0; c < 6; ++c) result.increment[c] = scale * trial[c];
    yield = q - 3 * shear_modulus * result.equivalent;
  }
  result.overshoot = std::max(0.0, q / yield_before - 1.0);
  result.excess = std::max(0.0, equivalent(s) / yield - 1.0);
  return result;
}

}  // namespace samcontact::plasticity
