// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heat_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::kernels {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
// exp(-z^2/4v^2) < 1e-16 for v < z / hidden.
constexpr double hidden = 12.2;
// Shift of a moving source across one panel, in widths.
constexpr double panel_shift = 2;

}  // namespace

HeatQuadrature::HeatQuadrature(double tol) : tol_(tol) {
  const double digits = -std::log10(tol);
  // Measured for speeds up to 1000 kappa/a, all ages and depths: one node more for each digit, and
  // one in reserve.
  rule_ = gauss_legendre(static_cast<int>(std::ceil(2 + digits)));
  reach_ = 2 * (std::sqrt(digits * std::numbers::ln10) + 1.5);
}

void HeatQuadrature::add_panel(std::vector<QuadratureNode>& nodes, double from, double to) const {
  for (const auto& [at, weight] : rule_) {
    nodes.push_back({from + (to - from) * at, (to - from) * weight});
  }
}

double HeatQuadrature::next_width(const HeatSource& source, const HeatSum& sum, double v) {
  if (!source.is_moving()) return 2 * v;
  // The oldest heat of a width passes a point within 1/speed in v. Behind the last point its effect
  // decreases like the inverse root of the distance, hence steps that double from there.
  const double passed = std::sqrt(sum.last_age(0));
  return v + std::min(v, panel_shift / source.speed() + std::max(0.0, v - passed));
}

double HeatQuadrature::first_width(const HeatSource& source, const HeatSum& sum, double z) const {
  const double narrowest = std::min(source.a, source.b);
  const double floor = 0.01 * tol_ * narrowest;
  if (z > hidden * floor) return z / hidden;
  const double edge = std::min(sum.along_x().edge_distance(), sum.along_y().edge_distance());
  const double width = std::clamp(edge / reach_, floor, narrowest);
  return source.is_moving() ? std::min(width, 1 / source.speed()) : width;
}

std::vector<HeatWidth> HeatQuadrature::newest_ages(const HeatSource& source, const HeatSum& sum,
                                                   double z) const {
  const double last = std::sqrt(source.heated);
  double from = first_width(source, sum, z);
  std::vector<QuadratureNode> nodes;
  if (z / hidden < from) add_panel(nodes, 0, std::min(from, last));
  while (from < last && sum.last_age(from) > from * from) {
    const double to = std::min(next_width(source, sum, from), last);
    add_panel(nodes, from, to);
    from = to;
  }
  std::vector<HeatWidth> widths;
  widths.reserve(nodes.size());
  for (const auto& [v, weight] : nodes) widths.push_back({v, weight, right_angle});
  return widths;
}

std::vector<HeatWidth> HeatQuadrature::all_widths(const HeatSource& source, const HeatSum& sum,
                                                  double z) const {
  const auto extent = [](const HeatProfile& profile) {
    return std::max(-profile.min(), profile.max()) + profile.half_size();
  };
  const double size = std::hypot(extent(sum.along_x()), extent(sum.along_y()), z);
  const double first = first_width(source, sum, z);
  const double oldest = std::sqrt(source.heated);
  // Beyond `end` a power series in 1/sqrt(v) (moving) or 1/v: one panel.
  const double end = source.is_steady()
                         ? 64 * std::max(size, 1 / source.speed())
                         : 8 * std::max({size, oldest, source.speed() * source.heated});
  std::vector<QuadratureNode> nodes;
  const bool hides = z / hidden >= first;
  if (!hides) add_panel(nodes, 0, std::min(first, oldest));
  for (double v = first; v < std::min(oldest, end);) {
    const double to = std::min({next_width(source, sum, v), oldest, end});
    add_panel(nodes, v, to);
    v = to;
  }
  std::vector<HeatWidth> widths;
  widths.reserve(nodes.size());
  for (const auto& [v, weight] : nodes) widths.push_back({v, weight, right_angle});
  if (source.is_steady()) {
    for (const auto& [at, weight] : rule_) {
      const double v = end / (at * at);
      widths.push_back({v, 2 * v / at * weight, right_angle});
    }
    return widths;
  }
  // v = oldest / sin(angle): otherwise a square-root singularity at v = oldest
  nodes.clear();
  double from = hides ? std::asin(std::min(1.0, oldest / first)) : right_angle;
  const double smallest = std::min(oldest / end, from);
  if (z > 0) {
    // Stress: the contribution of the oldest heat changes at angles z/2v from pi/2.
    const double finest = std::max(z / (16 * oldest), tol_ / 100);
    for (double gap = std::min(0.125, finest); gap < 0.5; gap *= 2) {
      if (right_angle - gap >= from) continue;
      add_panel(nodes, right_angle - gap, from);
      from = right_angle - gap;
    }
  }
  for (; from > 2 * smallest; from /= 2) add_panel(nodes, from / 2, from);
  add_panel(nodes, 0, from);
  for (const auto& [angle, weight] : nodes) {
    const double s = std::sin(angle);
    widths.push_back({oldest / s, weight * oldest * std::cos(angle) / (s * s), angle});
  }
  return widths;
}

std::vector<QuadratureNode> HeatQuadrature::angles(const HeatSource& source, const HeatSum& sum,
                                                   const HeatWidth& width, double finest) const {
  const double oldest = sum.last_age(width.v);
  const double S = width.v * width.v;
  double last = width.angle;
  if (oldest < S) last = std::min(last, std::asin(std::sqrt(oldest / S)));
  const double s = std::sin(last);
  const double shift = source.speed() * S * s * s;
  const int parts = 1 + static_cast<int>(shift / (panel_shift * width.v));
  std::vector<double> breaks;
  for (int n = 0; n <= parts; ++n) breaks.push_back(last * n / parts);
  // differences from pi/2 below the tolerance have no effect
  for (double gap = 1; gap > std::max(finest, tol_ / 100); gap /= 2) {
    if (right_angle - gap < last) breaks.push_back(right_angle - gap);
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<QuadratureNode> nodes;
  for (std::size_t n = 1; n < breaks.size(); ++n) add_panel(nodes, breaks[n - 1], breaks[n]);
  return nodes;
}

}  // namespace samcontact::kernels
