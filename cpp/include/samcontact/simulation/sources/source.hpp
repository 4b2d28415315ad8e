// SPDX-License-Identifier: GPL-3.0-or-later
// A source of displacement and stress besides the tractions and the plastic strain.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/zones/stress_bound.hpp"
#include "samcontact/simulation/scene/strength.hpp"

namespace samcontact::simulation {

/// Bodies are indexed 0 (upper) and 1 (lower). What a source does not override it does not cause.
class Source {
 public:
  virtual ~Source() = default;
  /// Whether it displaces or stresses a body.
  virtual bool acts_on(int body) const = 0;
  /// Whether it still acts on bodies without load.
  virtual bool remains() const = 0;
  /// Whether the search of cells that yield knows its stress; else see box_beyond().
  virtual bool is_smooth() const { return true; }
  /// Mirror planes that it leaves, where the scene and the increment do not know them.
  virtual fft::Symmetry symmetry() const { return fft::Symmetry::xy; }
  /// Adds its part of the separation of the undeformed surfaces [i][j] of the grid.
  virtual void separate(Field& /*gap*/) const {}
  /// Adds the displacement u_z of a body's surface [i][j] of the grid.
  virtual void displace(int /*body*/, Field& /*sum*/) const {}
  /// Adds the stress in a box of a body's cells, [component][k][i][j] of the tensor; an empty field
  /// is 0.
  virtual void stress(int /*body*/, const Box& /*box*/, operators::Tensor /*tensor*/,
                      Field& /*sum*/) const {}
  /// Deviator of the stress at depths below the grid, for the search of cells that yield; none:
  /// zero, or known to that search.
  virtual operators::DeviatorAt deviator(int /*body*/) const { return {}; }
  /// The box of all cells of the grid whose von Mises stress exceeds a share of the softened yield
  /// stress, where it varies from cell to cell, so that the search would miss some; empty: none.
  virtual Box box_beyond(int /*body*/, const Strength& /*strength*/, double /*softening*/,
                         double /*share*/) const {
    return {};
  }
};

/// Adds a field to a sum that is empty while it is 0.
inline void add_to(Field& sum, Field&& part) {
  if (sum.empty()) {
    sum = std::move(part);
  } else {
    for (std::size_t n = 0; n < part.size(); ++n) sum[n] += part[n];
  }
}

}  // namespace samcontact::simulation
