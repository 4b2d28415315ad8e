// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/complementarity.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {

double contact_mean(const Field& pressure, const Field& field) {
  const std::size_t n = field.size();
  const double sum = ordered_sum(n, [&](std::size_t i) { return pressure[i] > 0 ? field[i] : 0; });
  const double cells = ordered_sum(n, [&](std::size_t i) { return pressure[i] > 0 ? 1.0 : 0.0; });
  return cells > 0 ? sum / cells : 0.0;
}

double complementarity_error(const Field& pressure, const Field& displacement, const Field& gap) {
  const double p_max = *std::max_element(pressure.begin(), pressure.end());
  // Heat may raise a surface more than pressure lowers it.
  double u_max = 0.0;
  for (const double u : displacement) u_max = std::max(u_max, std::fabs(u));
  if (p_max <= 0 || u_max <= 0) {
    // No pressure yet: any penetration counts in full.
    return *std::min_element(gap.begin(), gap.end()) < 0 ? 1.0 : 0.0;
  }
  double largest = 0.0;
  const std::ptrdiff_t n = gap.size();
#pragma omp parallel for schedule(static) reduction(max : largest) if (n >= worth_threads_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    largest = std::max(largest, std::fabs(std::min(pressure[i] / p_max, gap[i] / u_max)));
  }
  return largest;
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
                 Driver driver, Field& gap) {
  const std::ptrdiff_t n = initial_gap.size();
#pragma omp parallel for schedule(static) if (n >= worth_threads_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) gap[i] = initial_gap[i] + displacement[i];
  const double approach = driver.is_load() ? contact_mean(pressure, gap) : driver.value;
  for (double& g : gap) g -= approach;
  return approach;
}

}  // namespace samcontact::contact
