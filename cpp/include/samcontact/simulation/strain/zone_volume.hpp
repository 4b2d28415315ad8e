// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in the zones of a body, and tractions, do: to the surface and in the zones.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::simulation {

/// Strain and stress are [component][cell] of stored zones, from the mirror planes on.
class ZoneVolume {
 public:
  using Use = std::function<void(std::size_t zone, int layer, const double* stress)>;

  virtual ~ZoneVolume() = default;
  /// axes: along which the displacement is wanted.
  virtual void transform(const Field& strain,
                         std::span<const operators::Axis> axes = operators::normal_axis) = 0;
  /// Where the displacement is known, one layer; stored.
  virtual const Box& surface() const = 0;
  /// Of the surface [i][j] due to the strain that was transformed last; odd ones of a stored part
  /// have the other sign beyond its mirror planes.
  virtual void displacement(operators::Axis axis, double* out) const = 0;
  /// The stress of the strain, which was transformed last, and of tractions on the grid: calls
  /// use(zone, layer, stress [component][i][j]), in any order and several at once; destroys what
  /// was transformed. strained: whether there is a strain. sign: of the shear.
  virtual void for_each_layer(bool strained, const Field& strain,
                              const operators::Tractions& tractions, double sign,
                              const Use& use) = 0;
};

}  // namespace samcontact::simulation
