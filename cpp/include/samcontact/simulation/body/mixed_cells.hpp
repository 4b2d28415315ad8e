// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a body in an increment that inclusions fill, completely or partly: their law and their
// own plastic strain.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/simulation/cells/inclusions.hpp"
#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// The strain of these cells in fields of a body is their eigenstrain: the strain that the
/// homogeneous matrix needs to have their stress. It contains plastic strain, misfit and mismatch.
class MixedCells {
 public:
  /// own: plastic strain of the mixed cells before the increment; null: none. first: row of the
  /// body at the first cell of the grid.
  MixedCells(const Setup& setup, int body, int first, fft::Symmetry symmetry,
             const std::shared_ptr<const PlasticState>& own);

  bool is_on() const { return inclusions_ != nullptr; }
  /// Whether moduli differ from those of the matrix by a large factor, as in a void.
  bool are_strong() const { return inclusions_ && inclusions_->are_strong(); }
  /// Whole box of the mixed cells that are solved for; empty: none.
  Box box() const;
  /// Sets the zones in which they are numbered.
  void take(const Zones& zones);

  /// Mixed cell; null in the matrix.
  const plasticity::MixedCell* at(std::size_t cell) const {
    return cells_.empty() ? nullptr : cells_[cell];
  }
  /// Step of a mixed cell from its present stress and eigenstrain. before: without the plastic
  /// strain, which is known here.
  plasticity::MixedReturn step(std::uint32_t cell, const plasticity::Tensor& stress,
                               const plasticity::Tensor& eigenstrain,
                               plasticity::MixedHistory before) const;
  /// Adds to the plastic strain of a mixed cell.
  void flow(std::uint32_t cell, const plasticity::Tensor& increment);
  /// Plastic strain of all mixed cells after the increment; null: none.
  std::shared_ptr<const PlasticState> finish() const;

 private:
  const Setup& setup_;
  std::shared_ptr<const Inclusions> inclusions_;
  int first_;
  fft::Symmetry symmetry_;
  std::optional<plasticity::MixedLaw> law_;
  std::shared_ptr<const PlasticState> own_;
  Zones zones_;
  std::vector<const plasticity::MixedCell*> cells_;  // by cell of the zones
  Field plastic_;  // [component][cell], five components; empty: no plastic strain
  bool flowed_ = false;
};

}  // namespace samcontact::simulation
