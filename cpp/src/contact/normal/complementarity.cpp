// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Rounding error of a displacement without mean value, relative to the longest wave.
constexpr double last_digits = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

bool all_finite(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); });
}

bool is_finite(const Solution& solution) {
  const auto is_gap = [](double g) { return std::isfinite(g) || g == INFINITY; };
  return all_finite(solution.tractions.pressure) &&
         std::all_of(solution.gap.begin(), solution.gap.end(), is_gap) &&
         std::isfinite(solution.load);
}

std::optional<Solution> separated(const Field& gap, double lowest, const Given& normal) {
  if (normal.is_force() ? normal.value != 0 : normal.value > lowest) return {};
  Solution solution;
  solution.motion.approach = normal.is_force() ? lowest : normal.value;
  solution.tractions.pressure.assign(gap.size(), 0.0);
  solution.gap = gap;
  for (double& g : solution.gap) g -= solution.motion.approach;
  return solution;
}

double rounding_error(const Field& gap, double lowest, double longest_wave) {
  const double of_wave = last_digits * longest_wave;
  // Flat surfaces: the rounding error of their distance may exceed their heights.
  const double of_gap = last_digits * std::fabs(lowest);
  const double heights = *std::max_element(gap.begin(), gap.end()) - lowest;
  return heights > of_gap ? of_wave : std::max(of_wave, of_gap);
}

double contact_mean(const Field& pressure, const Field& field) {
  const std::size_t n = field.size();
  const double cells =
      ordered_sum(n, [&](std::size_t i) { return in_contact(pressure[i]) ? 1.0 : 0.0; });
  const double sum =
      ordered_sum(n, [&](std::size_t i) { return in_contact(pressure[i]) ? field[i] : 0.0; });
  return cells > 0 ? sum / cells : 0.0;
}

double complementarity_error(const Field& pressure, const Field& displacement, const Field& gap,
                             double rounding) {
  return complementarity_error(
      pressure, [&](std::size_t i) { return displacement[i]; },
      [&](std::size_t i) { return std::fabs(gap[i]) > rounding ? gap[i] : 0.0; });
}

double scale_to_sum(Field& pressure, double sum) {
  const std::size_t n = pressure.size();
  const double present = ordered_sum(n, [&](std::size_t i) { return pressure[i]; });
  if (!(present > 0)) {
    std::fill(pressure.begin(), pressure.end(), sum / n);
    return 0.0;
  }
  const double scale = sum / present;
  for_each_cell(std::ssize(pressure), [&](std::ptrdiff_t i) { pressure[i] *= scale; });
  return scale;
}

AboutAxes moments(const Grid& grid, const Field& pressure) {
  const std::vector<double> x = grid.x(), y = grid.y();
  const std::size_t n = pressure.size();
  const double about_x =
      ordered_sum(n, [&](std::size_t i) { return pressure[i] * y[i % grid.ny]; });
  const double about_y =
      ordered_sum(n, [&](std::size_t i) { return pressure[i] * x[i / grid.ny]; });
  return {about_x * grid.cell_area(), -about_y * grid.cell_area()};
}

}  // namespace samcontact::contact
