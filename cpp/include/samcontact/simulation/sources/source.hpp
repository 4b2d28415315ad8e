// SPDX-License-Identifier: GPL-3.0-or-later
// Interface of sources of displacement and stress other than tractions and plastic strain.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/zones/stress_bound.hpp"
#include "samcontact/simulation/scene/strength.hpp"

namespace samcontact::simulation {

/// Bodies are indexed 0 (upper) and 1 (lower). Functions that a source does not override have no
/// effect.
class Source {
 public:
  virtual ~Source() = default;
  /// Whether the source causes displacement or stress in a body.
  virtual bool acts_on(int body) const = 0;
  /// Whether the source acts on bodies without load.
  virtual bool remains() const = 0;
  /// Whether the search for yield takes the stress of the source into account; otherwise see
  /// box_beyond().
  virtual bool is_smooth() const { return true; }
  /// Mirror planes that the source permits, if they are not known from the setup and the increment.
  virtual fft::Symmetry symmetry() const { return fft::Symmetry::xy; }
  /// Adds the effect of the source on the separation of the undeformed surfaces [i][j] of the grid
  /// [m].
  virtual void separate(Field& /*gap*/) const {}
  /// Adds the surface displacement u_z of a body [i][j] of the grid [m].
  virtual void displace(int /*body*/, Field& /*sum*/) const {}
  /// Adds the stress in a box of cells of a body, [component][k][i][j] of the tensor [Pa]; an empty
  /// field stands for 0.
  virtual void stress(int /*body*/, const Box& /*box*/, operators::Tensor /*tensor*/,
                      Field& /*sum*/) const {}
  /// Deviator of the stress at depths below the grid, for the search for yield; empty: zero, or
  /// already known to that search.
  virtual operators::DeviatorAt deviator(int /*body*/) const { return {}; }
  /// Box of all grid cells whose von Mises stress exceeds a fraction of the softened yield stress,
  /// for stress that varies from cell to cell, which the search could miss; empty: none.
  virtual Box box_beyond(int /*body*/, const Strength& /*strength*/, double /*softening*/,
                         double /*share*/) const {
    return {};
  }
};

/// Adds a field to a sum; an empty sum stands for 0.
inline void add_to(Field& sum, Field&& part) {
  if (sum.empty()) {
    sum = std::move(part);
  } else {
    for (std::size_t n = 0; n < part.size(); ++n) sum[n] += part[n];
  }
}

}  // namespace samcontact::simulation
