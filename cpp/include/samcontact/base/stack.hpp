// SPDX-License-Identifier: GPL-3.0-or-later
// Stack of perfectly bonded elastic layers on a substrate: the elastic structure of a coated body.
#pragma once

#include <vector>

#include "samcontact/base/elastic.hpp"

namespace samcontact {

struct ElasticLayer {
  Elastic elastic;
  double thickness;  // [m]

  bool operator==(const ElasticLayer&) const = default;
};

/// Layers from the surface down on a substrate of infinite depth, which may be rigid. Without
/// layers the body is homogeneous.
struct Stack {
  std::vector<ElasticLayer> layers;
  Elastic substrate;

  /// Throws std::invalid_argument unless all layers are elastic and of finite thickness > 0.
  static Stack of(std::vector<ElasticLayer> layers, const Elastic& substrate);

  bool is_rigid() const { return layers.empty() && substrate.is_rigid(); }
  bool operator==(const Stack&) const = default;

  /// Equivalent stack in which adjacent layers of identical material are merged.
  Stack merged() const;
  /// Depth of the bottom of the last layer [m].
  double thickness() const;
  /// Index of the layer at a depth, from the surface down; the number of layers stands for the
  /// substrate. A depth on an interface belongs to the layer below it.
  int layer_at(double z) const;
  const Elastic& elastic(int layer) const;
};

}  // namespace samcontact
