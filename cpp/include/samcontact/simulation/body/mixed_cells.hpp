// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a body in an increment that inclusions fill, completely or partly: their law and their
// own plastic strain.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/cells/inclusions.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"
#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/strain/plastic_state.hpp"

namespace samcontact::simulation {

/// The strain of these cells in fields of a body is their eigenstrain: the strain that the
/// homogeneous matrix needs to have their stress. It contains plastic strain, misfit and mismatch.
class MixedCells {
 public:
  /// Plastic strain of the mixed cells; with two phases that of the inclusion, and that of the
  /// matrix with the equivalent strain of the inclusion. Null: none.
  struct Flows {
    std::shared_ptr<const PlasticState> own, of_matrix;
  };
  /// before: the increment. first: row of the
  /// body at the first cell of the grid.
  MixedCells(const Setup& setup, int body, int first, fft::Symmetry symmetry, const Flows& before);

  bool is_on() const { return inclusions_ != nullptr; }
  /// Whether moduli differ from those of the matrix by a large factor, as in a void.
  bool are_strong() const { return inclusions_ && inclusions_->are_strong(); }
  /// Part of the plastic strain of an estimate that a step keeps in cells of a material of the
  /// matrix, see MixedLaw; 1 without mixed cells.
  double matrix_part(int material) const {
    return laws_.empty() ? 1.0 : laws_[material].matrix_part();
  }
  /// Whole box of the mixed cells that are solved for; empty: none.
  Box box() const;
  /// Columns down to the mixed cells that are solved for, of the whole grid.
  Columns columns() const;
  /// Whether their misfit depends on the temperature.
  bool expand() const { return inclusions_ && inclusions_->expand(); }
  /// Sets the temperature rise [K] in a box that contains `box()`.
  void warm(BoxField rise) { rise_ = std::move(rise); }
  /// Sets the zones in which they are numbered.
  void take(const Zones& zones);

  /// Indices of all mixed cells.
  const std::vector<std::uint32_t>& numbers() const { return numbers_; }
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
  void flow(std::uint32_t cell, const plasticity::MixedReturn& step);
  /// Plastic strain after the increment.
  Flows finish() const;

 private:
  /// Law of a mixed cell, which lies within one layer of the matrix.
  const plasticity::MixedLaw& law_of(std::uint32_t cell) const;

  const Setup& setup_;
  std::shared_ptr<const Inclusions> inclusions_;
  int first_;
  fft::Symmetry symmetry_;
  const plasticity::Body& matrix_;
  std::vector<plasticity::MixedLaw> laws_;  // by material of the matrix; empty: no mixed cells
  Flows before_;
  Zones zones_;
  std::vector<const plasticity::MixedCell*> cells_;  // by cell of the zones
  std::vector<std::uint32_t> numbers_;
  // Strain of Flows, [component][cell] with five components, and equivalent strain of the
  // inclusion in cells of two phases; empty: none.
  Field plastic_, matrix_plastic_, inclusion_equivalent_;
  BoxField rise_;  // empty: none
  bool flowed_ = false, matrix_flowed_ = false;
};

}  // namespace samcontact::simulation
