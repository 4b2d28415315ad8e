// SPDX-License-Identifier: GPL-3.0-or-later
// Active cells of an increment, which carry its unknowns: cells with plastic flow in at least one
// iteration.
#pragma once

#include <cstdint>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {

/// Grows while an increment is solved; never reordered.
class ActiveCells {
 public:
  struct Cell {
    std::uint8_t body;   // index among the elastic-plastic bodies
    std::uint32_t cell;  // index in the zones of that body
  };
  std::vector<Cell> cells;
  /// Deviator from the last evaluation; of mixed cells the whole stress.
  std::vector<plasticity::Tensor> stress;
  Field equivalent;  // increment from the last evaluation
  /// Indices of the cells that inclusions fill, completely or partly.
  std::vector<std::size_t> mixed;
  /// Steps of these cells from the last evaluation.
  std::vector<plasticity::MixedReturn> mixed_steps;

  std::size_t size() const { return cells.size(); }
  /// Components of the strain of a cell in fields of unknowns [cell][component].
  int components() const { return components_; }
  /// Uses all six components, for strain with a trace.
  void keep_trace() { components_ = 6; }

  /// Makes room for a number of cells: without it, appended cells take up to twice their memory.
  void reserve(std::size_t count);
  void append(const Cell& cell, const plasticity::Tensor& strain_before,
              const plasticity::Tensor& deviator);
  /// Moves to other zones of a body, which contain all its unknowns.
  void move(std::uint8_t body, const Zones& from, const Zones& to);

  /// Strain before the increment.
  plasticity::Tensor before(std::size_t n) const { return get(before_, n); }
  /// All six components of unknown n.
  plasticity::Tensor get(const Field& unknown, std::size_t n) const;
  void put(const plasticity::Tensor& t, Field& unknown, std::size_t n) const;
  /// Plastic strain of active cell n before the increment plus its value in a field of unknowns.
  plasticity::Tensor strain(const Field& increment, std::size_t n) const;

 private:
  int components_ = 5;
  Field before_;  // plastic strain before the increment
};

}  // namespace samcontact::simulation
