// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/thermal_stack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace samcontact {
namespace {

/// Part of the thickness of a layer below which the depths of two interfaces are equal: they are
/// sums of the same thicknesses in different order.
constexpr double same_depth = 1e-10;

}  // namespace

ThermalStack ThermalStack::merged() const {
  ThermalStack merged{{}, substrate};
  for (const ThermalLayer& layer : layers) {
    if (!merged.layers.empty() && merged.layers.back().thermal == layer.thermal) {
      merged.layers.back().thickness += layer.thickness;
    } else {
      merged.layers.push_back(layer);
    }
  }
  while (!merged.layers.empty() && merged.layers.back().thermal == substrate) {
    merged.layers.pop_back();
  }
  return merged;
}

HeatedStack HeatedStack::of(const Stack& elastic, const ThermalStack& thermal) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto thickness = [](const auto& layers, std::size_t n) {
    return n < layers.size() ? layers[n].thickness : infinite;
  };
  HeatedStack stack{{{}, elastic.substrate}, {}};
  std::size_t e = 0, t = 0;
  double left_e = thickness(elastic.layers, 0), left_t = thickness(thermal.layers, 0);
  for (;;) {
    const Thermal& own = t < thermal.layers.size() ? thermal.layers[t].thermal : thermal.substrate;
    const double h = std::min(left_e, left_t);
    if (std::isinf(h)) {
      stack.thermal.push_back(own);
      break;
    }
    const Elastic& here = elastic.elastic(static_cast<int>(e));
    auto& layers = stack.elastic.layers;
    if (!layers.empty() && layers.back().elastic == here && stack.thermal.back() == own) {
      layers.back().thickness += h;
    } else {
      layers.push_back({here, h});
      stack.thermal.push_back(own);
    }
    const bool both = std::fabs(left_e - left_t) <= same_depth * h;
    const bool elastic_ends = both || left_e < left_t, thermal_ends = both || left_t < left_e;
    left_e = elastic_ends ? thickness(elastic.layers, ++e) : left_e - h;
    left_t = thermal_ends ? thickness(thermal.layers, ++t) : left_t - h;
  }
  auto& layers = stack.elastic.layers;
  while (!layers.empty() && layers.back().elastic == stack.elastic.substrate &&
         stack.thermal[layers.size() - 1] == stack.thermal.back()) {
    stack.thermal.pop_back();
    layers.pop_back();
  }
  return stack;
}

double longest_heat_length(const HeatedStack& stack) {
  double ratio = 1.0;
  for (const Thermal& layer : stack.thermal) {
    ratio = std::max(ratio, layer.conductivity / stack.thermal.back().conductivity);
  }
  return 2 * stack.elastic.thickness() * ratio;
}

}  // namespace samcontact
