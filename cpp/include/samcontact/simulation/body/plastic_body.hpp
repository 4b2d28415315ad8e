// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic-plastic body in an increment: the zones that contain its plastic strain and all cells
// that may flow, and the stress there.
#pragma once

#include <memory>
#include <optional>
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
  /// from: state before the increment, with the bodies at their positions after the increment.
  /// number: index among the elastic-plastic bodies. copies: 2 if the other body is the mirror
  /// image in the contact plane. heating: proportional to the pressure.
  PlasticBody(const State& from, int index, std::uint8_t number, int copies, fft::Symmetry symmetry,
              const operators::Heating& heating);

  int index() const { return index_; }  // of the body: 0 or 1
  operators::Tensor tensor() const { return tensor_; }
  /// History of the body before the increment; null: no history.
  const std::shared_ptr<const PlasticState>& history() const { return history_; }
  /// Stored zones: the part on one side of the mirror planes.
  const Zones& zones() const { return cells_.zones(); }
  bool is_split() const { return split_; }
  bool strained() const { return strained_; }

  const CellHistory& cells() const { return cells_; }
  CellHistory& cells() { return cells_; }
  YieldSearch& search() { return search_; }
  const BodySurface& surface() const { return surface_; }
  BodySurface& surface() { return surface_; }

  /// Sets new zones, which contain all unknowns; values in common cells are kept. split: whether to
  /// use the operators of zones, or those of one box around them, which must then contain all
  /// tractions. Throws MemoryError.
  void set_zones(const Zones& zones, bool split, const Sources& sources, ActiveCells& active);
  /// Sets the first zones, with the operators of one box, and another history. outside: effect on
  /// them of the strain outside them.
  void set_zones(const Zones& zones, std::shared_ptr<const PlasticState> history,
                 OutsideStrain outside, const Sources& sources, ActiveCells& active);
  /// Sets the factor on the yield stress in a box that contains the zones; null: 1.
  void soften(std::shared_ptr<const BoxField> factor);

  /// Sets the strain of a cell including its unknowns, to be transformed next.
  void set_strain(std::uint32_t cell, const plasticity::Tensor& strain);
  /// Transforms the strain. active: whether the increment has unknowns.
  void transform(bool active);
  /// Sets the tractions of the increment, which must outlive this object.
  void set_tractions(const operators::Tractions& tractions);
  /// Tractions on the body, on its own cells.
  const operators::Tractions& tractions() const { return offset_ != 0 ? seen_ : *tractions_; }

  /// Computes the stress of the active cells; inactive cells that yield are appended. Returns the
  /// minimum of (yield stress - von Mises stress)/yield stress over the inactive cells.
  double find_stress(ActiveCells& active);
  void activate(std::uint32_t cell, const plasticity::Tensor& deviator, ActiveCells& active);
  /// Index of a cell among the active cells; -1 if it is inactive.
  int active_number(std::uint32_t cell) const { return active_[cell]; }
  /// History after the increment; this object must not be used afterwards.
  std::shared_ptr<const PlasticState> finish();

 private:
  /// Result of the yield check of a layer: inactive cells that yield, and the maximum of the
  /// squared von Mises stress over its limit for the other inactive cells.
  struct LayerCheck {
    std::vector<std::pair<std::uint32_t, plasticity::Tensor>> yielding;
    double largest = 0.0;
  };
  /// first: index of its first cell; plane: its number of cells.
  LayerCheck check_layer(std::size_t first, std::size_t plane, const double* layer,
                         const CellHistory::Limits& limits, ActiveCells& active) const;

  const Setup& setup_;
  int index_;
  std::uint8_t number_;
  operators::ResidualMethod method_;
  fft::Symmetry symmetry_;
  operators::Heating heating_;
  Strength strength_;
  std::shared_ptr<const PlasticState> history_;
  /// History for which the tractions were found, before extrapolation.
  std::shared_ptr<const PlasticState> met_;
  operators::Tensor tensor_ = operators::Tensor::deviator;
  bool rests_;           // relative to the grid
  double offset_ = 0.0;  // of its cells relative to those of the grid, see Placement
  CellHistory cells_;
  YieldSearch search_;
  BodySurface surface_;
  std::optional<OutsideStrain> known_outside_;  // for the next zones
  std::unique_ptr<ZoneVolume> volume_;          // null: no zones
  bool split_ = false;
  Field strain_;             // before the increment plus the last estimate
  std::vector<int> active_;  // per cell: its index among the active cells, or -1
  bool strained_ = false;
  std::vector<Field>
      given_stress_;  // by zone, due to everything except tractions and the strain in the zones
  const operators::Tractions* tractions_ = nullptr;
  operators::Tractions seen_;  // on cells at an offset
};

}  // namespace samcontact::simulation
