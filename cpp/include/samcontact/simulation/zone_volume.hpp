// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in the zones of a body, and tractions, do: to the surface and in the zones.
#pragma once

#include <cstddef>
#include <functional>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/tractions.hpp"

namespace samcontact::simulation {

/// Strain and stress are [component][cell] of stored zones, from the mirror planes on.
class ZoneVolume {
 public:
  using Use = std::function<void(std::size_t zone, int layer, const double* stress)>;

  virtual ~ZoneVolume() = default;
  virtual void transform(const Field& strain) = 0;
  /// Where the displacement is known, one layer; stored.
  virtual const Box& surface() const = 0;
  /// Of the surface [i][j] due to the strain that was transformed last.
  virtual void displacement(double* out) const = 0;
  /// The stress of the strain, which was transformed last, and of tractions on the grid: calls
  /// use(zone, layer, stress [component][i][j]), in any order and several at once; destroys what
  /// was transformed. strained: whether there is a strain. sign: of the shear.
  virtual void for_each_layer(bool strained, const Field& strain,
                              const operators::Tractions& tractions, double sign,
                              const Use& use) = 0;
};

}  // namespace samcontact::simulation
