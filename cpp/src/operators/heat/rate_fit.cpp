// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/rate_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::operators {
namespace {

/// Ages of the fit per factor e, and the part of its singular values that is left out.
constexpr double ages_per_e = 8.0, rank_cutoff = 1e-12;
/// Decay exponent after which a response is negligible.
constexpr double decayed_exponent = 40.0;
/// Tolerance of the inverse transform over that of the fit.
constexpr double contour_tolerance = 1e-4;

/// Hyperbola of M. Lopez-Fernandez and C. Palencia, Appl. Numer. Math. 51 (2004) 289: f(t) is the
/// sum of Im(weight F(s) exp(s t)) for all ages from the shortest one on.
void add_contour(const ResponseAges& ages, std::vector<std::complex<double>>& s,
                 std::vector<std::complex<double>>& weight) {
  const double digits = -std::log(contour_tolerance * ages.tolerance);
  const double step = 4.93 / digits, turned = std::numbers::sqrt2 / 2 * ages.slowest;
  const double end = std::acosh(1 + digits / (turned * ages.shortest));
  for (double u = 0; u <= end; u += step) {
    s.emplace_back(-turned * std::cosh(u), turned * std::sinh(u));
    const std::complex<double> slope(-turned * std::sinh(u), turned * std::cosh(u));
    weight.push_back((u == 0 ? 0.5 : 1.0) * step / std::numbers::pi * slope);
  }
}

}  // namespace

RateFit fit_rates(std::span<const double> rates, const ResponseAges& ages, double power) {
  RateFit fit;
  std::vector<std::complex<double>> weight;
  add_contour(ages, fit.s, weight);
  const double until = std::min(decayed_exponent / rates[0], 4 * ages.longest);
  const double span = std::log(std::max(until / ages.shortest, 4.0));
  const auto count = std::max(static_cast<Eigen::Index>(std::ceil(ages_per_e * span)),
                              2 * static_cast<Eigen::Index>(rates.size()));
  const auto rows = static_cast<Eigen::Index>(rates.size());
  const auto columns = static_cast<Eigen::Index>(fit.s.size());
  Eigen::MatrixXd decays(count, rows);
  Eigen::MatrixXcd responses(count, columns);
  for (Eigen::Index a = 0; a < count; ++a) {
    const double t = ages.shortest * std::exp(span * static_cast<double>(a) / (count - 1.0));
    const double share = t / std::pow(std::min(t, 1 / rates[0]), power);
    for (Eigen::Index j = 0; j < rows; ++j) decays(a, j) = share * std::exp(-rates[j] * t);
    for (Eigen::Index n = 0; n < columns; ++n) {
      responses(a, n) = share * weight[n] * std::exp(fit.s[n] * t);
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(rank_cutoff);
  solver.compute(decays);
  fit.weights.resize(rows, columns);
  fit.weights.real() = solver.solve(Eigen::MatrixXd(responses.real()));
  fit.weights.imag() = solver.solve(Eigen::MatrixXd(responses.imag()));
  return fit;
}

}  // namespace samcontact::operators
