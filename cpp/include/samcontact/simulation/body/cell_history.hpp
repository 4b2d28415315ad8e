// SPDX-License-Identifier: GPL-3.0-or-later
// Hardening and yield strength of the cells of a body in an increment, and their radial return.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/simulation/body/mixed_cells.hpp"
#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/setup/strength.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// For the numbered cells of disjoint zones.
class CellHistory {
 public:
  CellHistory(const plasticity::Body& body, MixedCells mixed)
      : body_(body), strain_at_yield_(body.strain_at_yield()), mixed_(std::move(mixed)) {}

  /// Sets zones, hardening and backstress before the increment, and the strength of the cells.
  void take(const Zones& zones, Field equivalent, Field backstress, const Strength& strength);
  /// With hardening and this number of backstresses from the history of the body; null: none.
  void take(const Zones& zones, const PlasticState* history, std::size_t terms,
            const Strength& strength);
  const Zones& zones() const { return zones_; }
  const MixedCells& mixed() const { return mixed_; }
  MixedCells& mixed() { return mixed_; }

  /// Sets the factor on the yield stress in a box that contains the zones; null: 1.
  void soften(std::shared_ptr<const BoxField> factor);
  const std::shared_ptr<const BoxField>& softening() const { return softening_; }
  double weakest() const { return weakest_; }  // minimum factor of the yield stress

  /// Squares of von Mises stresses, divided by 3.
  struct Limits {
    std::vector<double> first;  // by material, without hardening and profile
    double weakest;             // minimum over all cells
  };
  Limits first_limits() const;
  /// Limit of the stress of a cell in the increment. second: squared stress of the cell; below it,
  /// the common limit of all cells need not be exact.
  double limit(std::size_t cell, double second, const Limits& limits) const {
    const bool own = second > limits.weakest && (softening_ || equivalent_[cell] > 0);
    if (own) return yield_limit(static_cast<std::uint32_t>(cell));
    const double first = limits.first[material_number(cell)];
    return factor_.empty() ? first : first * (factor_[cell] * factor_[cell]);
  }
  bool has_backstress() const { return !backstress_.empty(); }
  /// Sum of the backstresses of a cell: xx, yy, yz, xz, xy.
  std::array<double, 5> centre(std::size_t cell) const {
    std::array<double, 5> sum{};
    int c = 0;
    for (std::size_t at = cell; at < backstress_.size(); at += zones_.cells()) {
      sum[c++ % 5] += backstress_[at];
    }
    return sum;
  }

  double strain_at_yield() const { return strain_at_yield_; }
  /// Radial return of a cell with an estimated plastic strain increment.
  plasticity::Return return_map(std::uint32_t cell, const plasticity::Tensor& deviator,
                                const plasticity::Tensor& guess) const;
  /// Equivalent strain, backstresses (stored in `place`) and strength of a cell before the
  /// increment.
  plasticity::MixedHistory before(std::uint32_t cell, plasticity::Tensors& place) const {
    plasticity::MixedHistory before;
    before.equivalent = equivalent_[cell];
    before.backstresses = backstresses(cell, place);
    before.strength = strength_of(cell);
    return before;
  }
  /// Updates the history of a cell for a plastic strain increment.
  void flow(std::uint32_t cell, const plasticity::Tensor& increment, double equivalent);
  /// Complete history, with the strain; this object must not be used afterwards.
  PlasticFields finish(Field strain);

 private:
  int material_number(std::size_t cell) const { return material_.empty() ? 0 : material_[cell]; }
  const plasticity::Material& material(std::size_t cell) const {
    return body_.material(material_number(cell));
  }
  double yield_limit(std::uint32_t cell) const;
  /// Factor of the yield stress of a cell.
  double strength_of(std::uint32_t cell) const;
  /// Backstresses of a cell for its material, before the increment, stored in `place`.
  std::span<const plasticity::Tensor> backstresses(std::uint32_t cell,
                                                   plasticity::Tensors& place) const;

  const plasticity::Body& body_;
  double strain_at_yield_;
  MixedCells mixed_;
  Zones zones_;
  Field equivalent_;                     // before the increment
  Field backstress_;                     // before the increment, [term][component][cell]
  Field factor_;                         // of the yield stress, by depth; empty: 1
  std::vector<std::uint16_t> material_;  // index for each cell; empty: a single material
  std::shared_ptr<const BoxField> softening_;
  double weakest_ = 1.0;
};

}  // namespace samcontact::simulation
