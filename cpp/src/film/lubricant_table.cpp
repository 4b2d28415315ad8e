// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/lubricant_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace samcontact::film {
namespace {

struct Smooth {
  double value, slope;
};

/// Cubic with given values and slopes at both ends of an interval; t: position in it, 0 to 1.
Smooth hermite(double t, double length, double from, double slope_from, double to,
               double slope_to) {
  const double rest = 1 - t;
  const double value = from * (1 + 2 * t) * rest * rest + to * t * t * (3 - 2 * t) +
                       length * t * rest * (slope_from * rest - slope_to * t);
  const double slope = 6 * t * rest * (to - from) / length + slope_from * rest * (1 - 3 * t) +
                       slope_to * t * (3 * t - 2);
  return {value, slope};
}

}  // namespace

LubricantTable::LubricantTable(Nodes nodes) : nodes_(std::move(nodes)) {
  const std::size_t n = nodes_.reduced.size();
  if (n < 2 || nodes_.fluidity.size() != n || nodes_.density.size() != n ||
      nodes_.density_slope.size() != n) {
    throw std::invalid_argument("tables of a lubricant must have the same length >= 2");
  }
  for (std::size_t k = 0; k < n; ++k) {
    pressures_.push_back(nodes_.scale * std::expm1(static_cast<double>(k) * nodes_.step));
  }
}

LubricantTable::Values LubricantTable::at(double pressure) const {
  const std::size_t last = pressures_.size() - 1;
  if (pressure >= pressures_[last]) {
    const double beyond = pressure - pressures_[last];
    return {nodes_.reduced[last] + nodes_.fluidity[last] * beyond, nodes_.fluidity[last],
            nodes_.density[last] + nodes_.density_slope[last] * beyond, nodes_.density_slope[last]};
  }
  const double at = std::log1p(std::max(pressure, 0.0) / nodes_.scale) / nodes_.step;
  const std::size_t k = std::min(static_cast<std::size_t>(at), last - 1);
  const double length = pressures_[k + 1] - pressures_[k];
  const double t = (pressure - pressures_[k]) / length;
  const Smooth q = hermite(t, length, nodes_.reduced[k], nodes_.fluidity[k], nodes_.reduced[k + 1],
                           nodes_.fluidity[k + 1]);
  const Smooth rho = hermite(t, length, nodes_.density[k], nodes_.density_slope[k],
                             nodes_.density[k + 1], nodes_.density_slope[k + 1]);
  return {q.value, q.slope, rho.value, rho.slope};
}

}  // namespace samcontact::film
