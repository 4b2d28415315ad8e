// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic layers on a substrate, perfectly bonded: what a coated body is made of.
#pragma once

#include <vector>

#include "samcontact/base/elastic.hpp"

namespace samcontact {

struct ElasticLayer {
  Elastic elastic;
  double thickness;  // [m]

  bool operator==(const ElasticLayer&) const = default;
};

/// Layers from the surface down, on a substrate without end, which may be rigid. Without layers a
/// homogeneous body.
struct Stack {
  std::vector<ElasticLayer> layers;
  Elastic substrate;

  /// Throws std::invalid_argument unless all layers are elastic and of finite thickness > 0.
  static Stack of(std::vector<ElasticLayer> layers, const Elastic& substrate);

  bool is_rigid() const { return layers.empty() && substrate.is_rigid(); }
  bool operator==(const Stack&) const = default;

  /// The same body with neighbours that are alike as one.
  Stack joined() const;
  /// Depth of the bottom of the last layer [m].
  double thickness() const;
  /// The layer at a depth, counted from the surface, as many as there are layers for the substrate.
  /// On an interface that below it.
  int layer_at(double z) const;
  const Elastic& elastic(int layer) const;
};

}  // namespace samcontact
