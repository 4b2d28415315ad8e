// SPDX-License-Identifier: GPL-3.0-or-later
// What the cells of a body bear before they have hardened: the yield stress of its materials over
// depth, and the stress that is there from the start.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/plasticity/body.hpp"
#include "samcontact/simulation/cells/motion.hpp"

namespace samcontact::simulation {

/// A layer that stands for others, [first, end).
struct LayerRange {
  int layer, first, end;
  bool operator==(const LayerRange&) const = default;
};

/// What some layers bear besides `start`, the deviator's xx, yy and xy [Pa].
struct LayerLimit {
  double stress;  // von Mises [Pa]; may be negative
  std::array<double, 3> start;
};

class Strength {
 public:
  /// body and relief: must outlive it. first: the relief's row at the grid's first cell. Throws
  /// std::invalid_argument for profiles of more layers than can be counted.
  Strength(const plasticity::Body& body, const Grid& grid, const Relief& relief, int first);

  /// Whether it depends on depth.
  bool is_graded() const { return variation_.has_value(); }
  /// Whether it is much less somewhere than above.
  bool weakens() const { return weakens_; }
  /// Layers below which nothing changes any more.
  int layers() const { return layers_; }
  /// Whether so much changes between two layers that both are to be looked at.
  bool differs(int above, int below) const;
  /// Whether they are of different materials.
  bool is_interface(int above, int below) const {
    return body_.number_at(mid_depth(above)) != body_.number_at(mid_depth(below));
  }

  /// Number of the material at mid-depth of the cells of a box [k][i][j]; empty: there is one.
  std::vector<std::uint16_t> materials(const Box& box) const;
  /// Factor of the yield stress at mid-depth of the cells of a box [k][i][j]; empty: 1.
  Field factor(const Box& box) const;
  /// Adds the stress of the start in a box [component][k][i][j]; an empty field is 0.
  void add_stress(const Box& box, operators::Tensor tensor, Field& sum) const;

  /// The least of what the layers of each range bear of a share of all stresses, another one where
  /// they are much weaker than what lies above: a cell whose stress is within it yields nowhere in
  /// the range. softening: factor of the yield stress.
  std::vector<LayerLimit> limits(const std::vector<LayerRange>& ranges, double softening,
                                 double share, double share_of_weak) const;

 private:
  /// Before it has hardened; infinite where nothing yields.
  double yield_stress_at(double z) const {
    const plasticity::Material& material = body_.at(z);
    return material.hardening.yield_stress(0.0) * material.yield_factor(z);
  }
  /// How much changes between two depths of one material, parts of its yield stress.
  double change(double above, double below) const;
  /// About how much pressure its axis bears: compression along the surface helps.
  double bearing_at(double z) const;
  bool is_weak_at(double z) const;
  /// Deviator of the stress of the start: xx, yy, xy.
  std::array<double, 3> start_at(double z) const;
  double mid_depth(int k) const { return (k + 0.5) * dz_; }
  /// Calls use(number of the cell, its mid-depth below the surface before wear) for all of a box in
  /// order.
  template <class Use>
  void for_cells(const Box& box, const Use& use) const;

  const plasticity::Body& body_;
  const Relief& relief_;
  int first_, ny_;
  double dz_;
  int layers_ = 0, worn_layers_ = 0;
  bool weakens_ = false;
  /// Sum of all changes from the surface on, parts of the yield stress; none: nothing changes.
  std::optional<OverDepth> variation_;
  OverDepth most_above_;  // largest bearing down to a depth, at kinks
};

}  // namespace samcontact::simulation
