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
                            const Hardening& hardening) {
  const double stiffness = 3 * shear_modulus;
  if (trial <= hardening.yield_stress(g)) return 0.0;
  // The yield stress is concave in g, so Newton's iterates rise monotonically to the root.
  double d = 0.0;
  for (int n = 0; n < 100; ++n) {
    const double excess = trial - stiffness * d - hardening.yield_stress(g + d);
    const double step = excess / (stiffness + hardening.slope(g + d));
    if (!(step > 0)) break;
    d += step;
    if (step <= 4 * std::numeric_limits<double>::epsilon() * d) break;
  }
  return d;
}

Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const Hardening& hardening) {
  const Tensor s = deviator(stress);
  Tensor trial = s;
  for (int c = 0; c < 6; ++c) trial[c] += 2 * shear_modulus * guess[c];
  const double q = equivalent(trial);
  Return result{};
  result.equivalent = equivalent_increment(q, g, shear_modulus, hardening);
  if (result.equivalent > 0) {
    const double scale = 1.5 * result.equivalent / q;
    for (int c = 0; c < 6; ++c) result.increment[c] = scale * trial[c];
  }
  result.overshoot = std::max(0.0, q / hardening.yield_stress(g) - 1.0);
  const double yield = hardening.yield_stress(g + result.equivalent);
  result.excess = std::max(0.0, equivalent(s) / yield - 1.0);
  return result;
}

}  // namespace samcontact::plasticity
