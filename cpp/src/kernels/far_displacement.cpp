// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/far_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "samcontact/base/multiversion.hpp"

namespace samcontact::kernels {
namespace {

constexpr int orders = FarDisplacement::orders;

/// Distance, in sizes of the rectangle, beyond which the tenth moment is below rounding.
constexpr double far_distance = 24.0;

double binomial(int n, int k) {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value *= static_cast<double>(n - k + i) / i;
  return value;
}

/// Mean of x^n over a segment of length `length` about 0.
double mean_power(double length, int n) {
  return n % 2 ? 0.0 : std::pow(0.5 * length, n) / (n + 1);
}

/// Mean of Re (s + i t)^m (s - i t)^n over the rectangle.
double moment(double width, double length, int m, int n) {
  double sum = 0.0;
  for (int p = 0; p <= m; ++p) {
    for (int q = p % 2; q <= n; q += 2) {  // others have no real part
      const double sign = (p - q) % 4 ? -1.0 : 1.0;
      sum += sign * binomial(m, p) * binomial(n, q) * mean_power(width, m + n - p - q) *
             mean_power(length, p + q);
    }
  }
  return sum;
}

/// Factors of the powers of c in the Chebyshev polynomial T_n(c).
std::array<double, orders + 1> chebyshev(int n) {
  std::array<double, orders + 1> before{}, now{};
  before[0] = 1.0;
  if (n == 0) return before;
  now[1] = 1.0;
  for (int k = 1; k < n; ++k) {
    std::array<double, orders + 1> next{};
    for (int d = 0; d <= orders; ++d) next[d] = (d > 0 ? 2.0 * now[d - 1] : 0.0) - before[d];
    before = now;
    now = next;
  }
  return now;
}

SAMCONTACT_MULTIVERSION
void evaluate_row(const FarDisplacement::Factors& f, double area, const double* x, double y,
                  std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double xx = x[i] * x[i], yy = y * y, q = 1.0 / (xx + yy), c = (xx - yy) * q;
    double sum = 0.0;
    for (int k = orders; k >= 0; --k) {
      double polynomial = 0.0;
      for (int d = k; d >= 0; --d) polynomial = polynomial * c + f[k][d];
      sum = sum * q + polynomial;
    }
    out[i] = area * std::sqrt(q) * sum;
  }
}

}  // namespace

// 1/|R - s| = sum of |s|^l P_l(cos g) / R^(l+1), g the angle between them, with
// P_l(cos g) = sum over j = 0..l of A_j A_(l-j) cos((l - 2 j) g), A_j = (2 j - 1)!! / (2 j)!!;
// odd l vanish in the mean over the rectangle.
FarDisplacement::FarDisplacement(double width, double length)
    : area_(width * length), valid_from_(far_distance * std::max(width, length)) {
  std::array<double, 2 * orders + 1> a{1.0};
  for (int j = 1; j <= 2 * orders; ++j) a[j] = a[j - 1] * (2 * j - 1) / (2 * j);
  for (int k = 0; k <= orders; ++k) {
    for (int j = 0; j <= 2 * k; ++j) {
      const double factor = a[j] * a[2 * k - j] * moment(width, length, 2 * k - j, j);
      const auto powers = chebyshev(std::abs(k - j));
      for (int d = 0; d <= k; ++d) factors_[k][d] += factor * powers[d];
    }
  }
}

void FarDisplacement::evaluate(const double* x, double y, std::size_t count, double* out) const {
  evaluate_row(factors_, area_, x, y, count, out);
}

}  // namespace samcontact::kernels
