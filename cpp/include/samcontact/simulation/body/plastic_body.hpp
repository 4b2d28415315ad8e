// SPDX-License-Identifier: GPL-3.0-or-later
// An inelastic body in an increment: the zones that hold its plastic strain and every cell that may
// flow, and the stress there.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/body/body_surface.hpp"
#include "samcontact/simulation/body/cell_history.hpp"
#include "samcontact/simulation/body/yield_search.hpp"
#include "samcontact/simulation/sources/sources.hpp"
#include "samcontact/simulation/state/state.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

class PlasticBody {
 public:
  /// from: with the bodies where the increment takes them. number: its own among the inelastic
  /// bodies. copies: 2 where the other body is its mirror image in the contact plane.
  /// heating: that goes with the pressure.
  PlasticBody(const State& from, int index, std::uint8_t number, int copies, fft::Symmetry symmetry,
              const operators::Heating& heating);

  int index() const { return index_; }  // of the body: 0 or 1
  operators::Tensor tensor() const { return tensor_; }
  /// Before the increment; null: none.
  const std::shared_ptr<const PlasticState>& history() const { return history_; }
  /// Stored: from the mirror planes on.
  const Zones& zones() const { return cells_.zones(); }
  bool is_split() const { return split_; }
  bool strained() const { return strained_; }

  const CellHistory& cells() const { return cells_; }
  CellHistory& cells() { return cells_; }
  YieldSearch& search() { return search_; }
  const BodySurface& surface() const { return surface_; }
  BodySurface& surface() { return surface_; }

  /// Other zones, which hold all unknowns: what is in both stays. split: whether their operators
  /// are to be those of zones, or that of the box around them, which must hold all tractions then.
  /// Throws MemoryError.
  void set_zones(const Zones& zones, bool split, const Sources& sources, ActiveCells& active);
  /// Factor of the yield stress in a box that holds its own; null: 1.
  void soften(std::shared_ptr<const BoxField> factor);

  /// Of a cell, with its unknowns; transformed next.
  void set_strain(std::uint32_t cell, const plasticity::Tensor& strain);
  /// Transforms the strain. active: whether the increment has unknowns.
  void transform(bool active);
  /// Tractions of the increment; outlive it.
  void meet(const operators::Tractions& tractions);
  /// What acts on it, in its own cells.
  const operators::Tractions& tractions() const { return offset_ != 0 ? seen_ : *tractions_; }

  /// Stress of its active cells; cells that yield and were not active are appended. Returns the
  /// smallest (yield stress - von Mises)/yield stress of cells that are not active.
  double find_stress(ActiveCells& active);
  void activate(std::uint32_t cell, const plasticity::Tensor& deviator, ActiveCells& active);
  /// The history after the increment; ends the use of this object.
  std::shared_ptr<const PlasticState> finish();

 private:
  /// What a look at a layer finds: cells that yield and were not active, and the largest square of
  /// a von Mises stress over its limit of those that are not.
  struct Seen {
    std::vector<std::pair<std::uint32_t, plasticity::Tensor>> yielding;
    double largest = 0.0;
  };
  /// first: the number of its first cell; plane: how many it has.
  Seen look_at_layer(std::size_t first, std::size_t plane, const double* layer,
                     const CellHistory::Limits& limits, ActiveCells& active) const;
  /// Adds what else stresses a layer.
  Field with_given_stress(std::size_t zone, int k, const double* layer) const;

  const Scene& scene_;
  int index_;
  std::uint8_t number_;
  operators::ResidualMethod method_;
  fft::Symmetry symmetry_;
  operators::Heating heating_;
  Strength strength_;
  std::shared_ptr<const PlasticState> history_;
  /// The same as the surfaces met with it, before it was extrapolated.
  std::shared_ptr<const PlasticState> met_;
  operators::Tensor tensor_ = operators::Tensor::deviator;
  double offset_ = 0.0;  // of its cells from the grid's, see Placement
  CellHistory cells_;
  YieldSearch search_;
  BodySurface surface_;
  std::unique_ptr<ZoneVolume> volume_;  // null: no zones
  bool split_ = false;
  Field strain_;             // before the increment plus the last guess
  std::vector<int> active_;  // per cell: its place among the active ones, or -1
  bool strained_ = false;
  std::vector<Field> given_stress_;  // by zone, of all but tractions and the strain in the zones
  const operators::Tractions* tractions_ = nullptr;
  operators::Tractions seen_;  // from cells at an offset
};

}  // namespace samcontact::simulation
