// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of an increment that flow, or did in one of its iterations: the unknowns.
#pragma once

#include <cstdint>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {

/// Appended to while an increment is solved, never reordered.
class ActiveCells {
 public:
  struct Cell {
    std::uint8_t body;   // index among the inelastic bodies
    std::uint32_t cell;  // number in that body's zones
  };
  std::vector<Cell> cells;
  std::vector<plasticity::Tensor> stress;  // deviator, of the last evaluation
  Field equivalent;                        // increment of the last evaluation

  std::size_t size() const { return cells.size(); }
  /// Of the strain of a cell in fields of unknowns [cell][component].
  int components() const { return components_; }
  /// Strain with a trace is to be told from all six.
  void keep_trace() { components_ = 6; }

  void append(const Cell& cell, const plasticity::Tensor& strain_before,
              const plasticity::Tensor& deviator);
  /// Into other zones of a body, which hold all of its unknowns.
  void move(std::uint8_t body, const Zones& from, const Zones& to);

  /// All six components of unknown number n.
  plasticity::Tensor get(const Field& unknown, std::size_t n) const;
  void put(const plasticity::Tensor& t, Field& unknown, std::size_t n) const;
  /// Plastic strain of cell number n before the increment, plus that of a field of unknowns.
  plasticity::Tensor strain(const Field& increment, std::size_t n) const;

 private:
  int components_ = 5;
  Field before_;  // plastic strain before the increment
};

}  // namespace samcontact::simulation
