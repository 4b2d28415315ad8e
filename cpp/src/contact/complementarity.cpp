// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/complementarity.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {

bool all_finite(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); });
}

bool is_finite(const Solution& solution) {
  return all_finite(solution.tractions.pressure) && all_finite(solution.gap) &&
         std::isfinite(solution.load);
}

double contact_mean(const Field& pressure, const Field& field) {
  const std::size_t n = field.size();
  std::size_t cells = 0;
  for (std::size_t i = 0; i < n; ++i) cells += pressure[i] > 0;
  const double sum =
      ordered_sum(n, [&](std::size_t i) { return pressure[i] > 0 ? field[i] : 0.0; });
  return cells > 0 ? sum / cells : 0.0;
}

double complementarity_error(const Field& pressure, const Field& displacement, const Field& gap) {
  return complementarity_error(
      pressure, [&](std::size_t i) { return displacement[i]; },
      [&](std::size_t i) { return gap[i]; });
}

double scale_to_sum(Field& pressure, double sum) {
  const std::size_t n = pressure.size();
  const double present = ordered_sum(n, [&](std::size_t i) { return pressure[i]; });
  if (!(present > 0)) {
    std::fill(pressure.begin(), pressure.end(), sum / n);
    return 0.0;
  }
  const double scale = sum / present;
  for (double& p : pressure) p *= scale;
  return scale;
}

double close_gap(const Field& initial_gap, const Field& displacement, const Field& pressure,
                 Given normal, Field& gap) {
  const std::ptrdiff_t n = initial_gap.size();
#pragma omp parallel for schedule(static) if (n >= worth_threads_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) gap[i] = initial_gap[i] + displacement[i];
  const double approach = normal.is_force() ? contact_mean(pressure, gap) : normal.value;
#pragma omp parallel for schedule(static) if (n >= worth_threads_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) gap[i] -= approach;
  return approach;
}

}  // namespace samcontact::contact
