// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of plastic strain in the zones of a body, and of tractions: surface displacement, and
// stress in the zones.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::simulation {

/// Strain and stress are [component][cell] of stored zones, on one side of the mirror planes.
class ZoneVolume {
 public:
  using Use = std::function<void(std::size_t zone, int layer, const double* stress)>;

  virtual ~ZoneVolume() = default;
  /// Transforms the strain. axes: axes of the required displacement.
  virtual void transform(const Field& strain,
                         std::span<const operators::Axis> axes = operators::normal_axis) = 0;
  /// Surface cells with known displacement, one layer; stored.
  virtual const Box& surface() const = 0;
  /// Surface displacement [i][j] [m] due to the last transformed strain; odd components have the
  /// opposite sign beyond the mirror planes.
  virtual void displacement(operators::Axis axis, double* out) const = 0;
  /// Stress due to the last transformed strain and to tractions on the grid [Pa]: calls use(zone,
  /// layer of the zone, stress [component][i][j]) in any order and from several threads at once;
  /// destroys the transformed strain. strained: whether there is strain. sign: of the shear.
  virtual void for_each_layer(bool strained, const Field& strain,
                              const operators::Tractions& tractions, double sign,
                              const Use& use) = 0;
};

}  // namespace samcontact::simulation
