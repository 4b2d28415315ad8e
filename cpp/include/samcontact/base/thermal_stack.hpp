// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal structure of a layered body, and its combination with the elastic structure.
#pragma once

#include <vector>

#include "samcontact/base/stack.hpp"
#include "samcontact/base/thermal.hpp"

namespace samcontact {

struct ThermalLayer {
  Thermal thermal;
  double thickness;  // [m]

  bool operator==(const ThermalLayer&) const = default;
};

/// Layers from the surface down in perfect thermal contact, on a substrate of infinite depth.
struct ThermalStack {
  std::vector<ThermalLayer> layers;
  Thermal substrate;

  bool operator==(const ThermalStack&) const = default;
  bool is_uniform() const { return layers.empty(); }
  /// Equivalent stack in which adjacent layers of identical constants are merged.
  ThermalStack merged() const;
};

/// Layers that differ in elastic or thermal constants, from the surface down.
struct HeatedStack {
  Stack elastic;
  std::vector<Thermal> thermal;  // of each layer, that of the substrate last

  /// Divided at the interfaces of both; adjacent layers that are identical are merged.
  static HeatedStack of(const Stack& elastic, const ThermalStack& thermal);
  /// Homogeneous body of the material of one layer.
  HeatedStack only(int layer) const { return {{{}, elastic.elastic(layer)}, {thermal[layer]}}; }
  bool is_uniform() const { return elastic.layers.empty(); }
};

/// Length over which a body differs from its substrate [m]: layers that conduct well spread heat.
double longest_heat_length(const HeatedStack& stack);

}  // namespace samcontact
