// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/stack.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact {

Stack Stack::of(std::vector<ElasticLayer> layers, const Elastic& substrate) {
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const std::string name = "layers[" + std::to_string(n) + "]";
    const auto& [elastic, thickness] = layers[n];
    require(!elastic.is_rigid(), name, "elastic: only the substrate may be rigid", elastic.E);
    require(std::isfinite(thickness) && thickness > 0, "thickness of " + name,
            "a finite number > 0 [m]", thickness);
    require_moderate("thickness of " + name, thickness, "[m]");
  }
  return {std::move(layers), substrate};
}

Stack Stack::merged() const {
  Stack merged{{}, substrate};
  for (const ElasticLayer& layer : layers) {
    if (!merged.layers.empty() && merged.layers.back().elastic == layer.elastic) {
      merged.layers.back().thickness += layer.thickness;
    } else {
      merged.layers.push_back(layer);
    }
  }
  while (!merged.layers.empty() && merged.layers.back().elastic == substrate) {
    merged.layers.pop_back();
  }
  return merged;
}

double Stack::thickness() const {
  double sum = 0.0;
  for (const ElasticLayer& layer : layers) sum += layer.thickness;
  return sum;
}

int Stack::layer_at(double z) const {
  double bottom = 0.0;
  for (std::size_t n = 0; n < layers.size(); ++n) {
    bottom += layers[n].thickness;
    if (z < bottom) return static_cast<int>(n);
  }
  return static_cast<int>(layers.size());
}

const Elastic& Stack::elastic(int layer) const {
  return layer < static_cast<int>(layers.size()) ? layers[layer].elastic : substrate;
}

}  // namespace samcontact
