// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a body that inclusions fill, completely or partly.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/plasticity/mixed_cell.hpp"
#include "samcontact/simulation/cells/mirror.hpp"

namespace samcontact::simulation {

/// Immutable. Cells are counted from the first cell of the grid at the start; a body that moves
/// takes its inclusions along.
class Inclusions {
 public:
  using Materials = std::vector<plasticity::Material>;

  /// Values of the cells of a box whose first layer is k0, [k][i][j]; number: index of a cell among
  /// `cells`, -1 in the matrix.
  Inclusions(const Box& box, int k0, std::vector<std::int32_t> number,
             std::vector<plasticity::MixedCell> cells, Materials materials);

  /// Mixed cell; null in the matrix. first: row of the body at the first cell of the grid.
  const plasticity::MixedCell* at(int i, int j, int k, int first, const Period& period) const {
    int row = i + first - box_.i0;
    if (period.x > 0) row = (row % period.x + period.x) % period.x;
    const int column = j - box_.j0, layer = k - k0_;
    if (row < 0 || row >= box_.nx || column < 0 || column >= box_.ny || layer < 0 ||
        layer >= box_.nz)
      return nullptr;
    const std::int32_t n =
        number_[(static_cast<std::size_t>(layer) * box_.nx + row) * box_.ny + column];
    return n < 0 ? nullptr : &cells_[n];
  }
  /// Material of the inclusion in a cell; null: void.
  const plasticity::Material* material(const plasticity::MixedCell& cell) const {
    return cell.material < 0 ? nullptr : &materials_[cell.material];
  }
  /// Box of the mixed cells that lie in the grid along x, down to their last layer; empty: none.
  Box in_grid(const Grid& grid, int first) const;
  /// Mirror planes of the mixed cells of a body that has not moved.
  fft::Symmetry symmetry(const Grid& grid) const;
  bool has_misfit() const { return has_misfit_; }
  /// Whether the expansion of a cell differs from that of the matrix.
  bool expand() const { return expand_; }
  /// Whether moduli of a cell differ from those of the matrix by a large factor.
  bool are_strong() const { return strong_; }
  std::size_t bytes() const;

 private:
  Box box_;
  int k0_;
  std::vector<std::int32_t> number_;
  std::vector<plasticity::MixedCell> cells_;
  Materials materials_;
  bool has_misfit_, expand_, strong_;
};

/// By body; null: homogeneous.
using InclusionsPair = std::array<std::shared_ptr<const Inclusions>, 2>;

}  // namespace samcontact::simulation
