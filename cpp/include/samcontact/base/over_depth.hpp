// SPDX-License-Identifier: GPL-3.0-or-later
// Depth profile of a quantity: piecewise linear between the given depths, constant beyond them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace samcontact {

struct OverDepth {
  std::vector<double> depth, value;  // [m], strictly ascending; equal numbers of both, at least one

  double at(double z) const {
    const auto next = std::upper_bound(depth.begin(), depth.end(), z);
    if (next == depth.begin()) return value.front();
    if (next == depth.end()) return value.back();
    const auto n = static_cast<std::size_t>(next - depth.begin());
    const double part = (z - depth[n - 1]) / (depth[n] - depth[n - 1]);
    return value[n - 1] + part * (value[n] - value[n - 1]);
  }
  /// Minimum over all depths.
  double smallest() const { return *std::min_element(value.begin(), value.end()); }
  bool operator==(const OverDepth&) const = default;
};

}  // namespace samcontact
