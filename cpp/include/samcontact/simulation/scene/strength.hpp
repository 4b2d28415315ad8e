// SPDX-License-Identifier: GPL-3.0-or-later
// Initial yield strength of the cells of a body: yield stress of its materials over depth, and
// initial stress.
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

/// Layer that represents the layers [first, end).
struct LayerRange {
  int layer, first, end;
  bool operator==(const LayerRange&) const = default;
};

/// Additional von Mises stress at which these layers yield, given an initial stress `start`: xx, yy
/// and xy of its deviator [Pa].
struct LayerLimit {
  double stress;  // von Mises [Pa]; may be negative
  std::array<double, 3> start;
};

class Strength {
 public:
  /// body and relief must outlive this object. first: row of the relief at the first cell of the
  /// grid. Throws std::invalid_argument for profiles with more layers than can be counted.
  Strength(const plasticity::Body& body, const Grid& grid, const Relief& relief, int first);

  /// Whether the strength depends on depth.
  bool is_graded() const { return variation_.has_value(); }
  /// Whether the strength at some depth is much lower than at smaller depths.
  bool weakens() const { return weakens_; }
  /// Number of layers below which the strength is constant.
  int layers() const { return layers_; }
  /// Whether the strengths of two layers differ so much that both must be checked.
  bool differs(int above, int below) const;
  /// Whether two layers are of different materials.
  bool is_interface(int above, int below) const {
    return body_.number_at(mid_depth(above)) != body_.number_at(mid_depth(below));
  }

  /// Index of the material at mid-depth of the cells of a box [k][i][j]; empty: a single material.
  std::vector<std::uint16_t> materials(const Box& box) const;
  /// Factor on the yield stress at mid-depth of the cells of a box [k][i][j]; empty: 1.
  Field factor(const Box& box) const;
  /// Adds the initial stress in a box [component][k][i][j]; an empty field stands for 0.
  void add_stress(const Box& box, operators::Tensor tensor, Field& sum) const;

  /// Lower bounds of the strength of the layers of each range, as a fraction `share` of their yield
  /// stress, or `weak_share` if they are much weaker than the layers above: a cell whose stress
  /// is within the bound yields in no layer of the range. softening: factor on the yield stress.
  std::vector<LayerLimit> limits(const std::vector<LayerRange>& ranges, double softening,
                                 double share, double weak_share) const;

 private:
  /// Initial yield stress [Pa]; infinite in elastic materials.
  double yield_stress_at(double z) const {
    const plasticity::Material& material = body_.at(z);
    return material.hardening.yield_stress(0.0) * material.yield_factor(z);
  }
  /// Change between two depths of one material, relative to its yield stress.
  double change(double above, double below) const;
  /// Approximate pressure above which the axis yields [Pa]: compressive stress along the surface
  /// raises it.
  double yield_pressure_at(double z) const;
  bool is_weak_at(double z) const;
  /// Deviator of the initial stress: xx, yy, xy [Pa].
  std::array<double, 3> start_at(double z) const;
  double mid_depth(int k) const { return (k + 0.5) * dz_; }
  /// Calls use(index of the cell, its mid-depth below the original surface) for all cells of a box
  /// in order.
  template <class Use>
  void for_cells(const Box& box, const Use& use) const;

  const plasticity::Body& body_;
  const Relief& relief_;
  int first_, ny_;
  double dz_;
  int layers_ = 0, worn_layers_ = 0;
  bool weakens_ = false;
  /// Sum of all changes from the surface down, relative to the yield stress; empty: the strength is
  /// constant.
  std::optional<OverDepth> variation_;
  OverDepth max_above_;  // maximum of yield_pressure_at() down to a depth, at kinks
};

}  // namespace samcontact::simulation
