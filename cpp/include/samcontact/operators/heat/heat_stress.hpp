// SPDX-License-Identifier: GPL-3.0-or-later
// Stress influence of one heated cell, cached by depth for all grids of equal cells: the tables of
// a moving source take longer to compute than all other data of a box.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/heat/heat_medium.hpp"

namespace samcontact::operators {

/// Components of a tensor, from all six.
std::vector<ParityParts> parts_of(std::array<ParityParts, 6> stress, Tensor tensor);

/// Thread-safe.
class HeatStress {
 public:
  using Tables = std::array<ParityParts, 6>;  // components xx, yy, zz, yz, xz, xy

  /// For boxes of cells of `widest`.
  HeatStress(const Grid& widest, SharedThermalStress body, const Heating& heating);
  /// Without a cache.
  HeatStress(SharedThermalStress body, Heating heating);

  const Heating& heating() const { return heating_; }
  const SharedThermalStress& body() const { return body_; }
  /// Tables at a depth, on offsets of the cells of a grid; computed for other offsets than those of
  /// the widest grid if necessary.
  Tables at(double z, const Grid& grid, const KernelOffsets& offsets) const;
  std::size_t bytes() const;

 private:
  Tables compute(double z, const Grid& grid, const KernelOffsets& offsets) const;

  SharedThermalStress body_;
  Heating heating_;
  std::optional<Grid> widest_;  // none: nothing is cached
  mutable std::mutex mutex_;
  mutable std::map<double, std::shared_ptr<const Tables>> kept_;
};

}  // namespace samcontact::operators
