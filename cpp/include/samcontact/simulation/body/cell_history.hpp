// SPDX-License-Identifier: GPL-3.0-or-later
// Hardening and strength of the cells of a body in an increment, and their return to the yield
// surface.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/scene/strength.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// Of disjoint zones, whose cells are numbered.
class CellHistory {
 public:
  explicit CellHistory(const plasticity::Body& body) : body_(body) {}

  /// Takes zones, hardening and backstress before the increment, and the strength of the cells.
  void take(const Zones& zones, Field equivalent, Field backstress, const Strength& strength);
  const Zones& zones() const { return zones_; }

  /// Factor of the yield stress in a box that holds the zones; null: 1.
  void soften(std::shared_ptr<const BoxField> factor);
  const std::shared_ptr<const BoxField>& softening() const { return softening_; }
  double weakest() const { return weakest_; }  // the smallest factor

  /// Squares of von Mises stresses, over 3.
  struct Limits {
    std::vector<double> first;  // by material, before hardening and its profile
    double weakest;             // of all cells
  };
  Limits first_limits() const;
  /// The same of a cell, in the increment. second: of its stress, below which the limit of all
  /// cells need not be exact.
  double limit(std::size_t cell, double second, const Limits& limits) const {
    const bool own = second > limits.weakest && (softening_ || equivalent_[cell] > 0);
    if (own) return yield_limit(static_cast<std::uint32_t>(cell));
    const double first = limits.first[material_number(cell)];
    return factor_.empty() ? first : first * (factor_[cell] * factor_[cell]);
  }
  bool has_backstress() const { return !backstress_.empty(); }
  /// Sum of its backstresses: xx, yy, yz, xz, xy.
  std::array<double, 5> centre(std::size_t cell) const {
    std::array<double, 5> sum{};
    int c = 0;
    for (std::size_t at = cell; at < backstress_.size(); at += zones_.cells()) {
      sum[c++ % 5] += backstress_[at];
    }
    return sum;
  }

  double strain_at_yield() const { return body_.strain_at_yield(); }
  /// Radial return of a cell, whose flow was guessed.
  plasticity::Return return_map(std::uint32_t cell, const plasticity::Tensor& deviator,
                                const plasticity::Tensor& guess) const;
  /// Its history after a flow by `increment`.
  void flow(std::uint32_t cell, const plasticity::Tensor& increment, double equivalent);
  /// All of it, with the strain; ends the use of this object.
  PlasticFields finish(Field strain);

 private:
  int material_number(std::size_t cell) const { return material_.empty() ? 0 : material_[cell]; }
  const plasticity::Material& material(std::size_t cell) const {
    return body_.material(material_number(cell));
  }
  double yield_limit(std::uint32_t cell) const;
  /// Factor of the yield stress.
  double strength_of(std::uint32_t cell) const;
  /// Of its material, before the increment, into the first places.
  std::span<const plasticity::Tensor> backstresses(std::uint32_t cell,
                                                   plasticity::Tensors& place) const;

  const plasticity::Body& body_;
  Zones zones_;
  Field equivalent_;                     // before the increment
  Field backstress_;                     // before the increment, [term][component][cell]
  Field factor_;                         // of the yield stress, by depth; empty: 1
  std::vector<std::uint16_t> material_;  // number of each cell's; empty: there is one
  std::shared_ptr<const BoxField> softening_;
  double weakest_ = 1.0;
};

}  // namespace samcontact::simulation
