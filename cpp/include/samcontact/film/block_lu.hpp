// SPDX-License-Identifier: GPL-3.0-or-later
// Multifrontal LU decomposition of a matrix that couples near cells of a grid (Duff, Reid, ACM
// Trans. Math. Softw. 9, 1983), in single precision: the blocks of a nested dissection are
// eliminated one after another from dense matrices.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/film/dense_lu.hpp"
#include "samcontact/film/dissection.hpp"

namespace samcontact::film {

/// Matrix whose rows have entries for the cells around their own.
class NearMatrix {
 public:
  /// reach: largest distance of cells that are coupled, along x and along y.
  NearMatrix(const Lattice& lattice, int reach)
      : lattice_(lattice),
        reach_(reach),
        reach_y_(lattice.ny() > 1 ? reach : 0),
        values_(lattice.size() * width(), 0.0F) {}

  const Lattice& lattice() const { return lattice_; }
  int reach() const { return reach_; }
  int reach_y() const { return reach_y_; }
  /// Number of entries of a row.
  int width() const { return (2 * reach_ + 1) * (2 * reach_y_ + 1); }
  /// Number of the entry for a neighbour; -1 if the neighbour is not near.
  int slot(int along_x, int along_y) const {
    if (along_x < -reach_ || along_x > reach_ || along_y < -reach_y_ || along_y > reach_y_) {
      return -1;
    }
    return (along_x + reach_) * (2 * reach_y_ + 1) + along_y + reach_y_;
  }
  float* row(std::size_t cell) { return values_.data() + cell * width(); }
  const float* row(std::size_t cell) const { return values_.data() + cell * width(); }

 private:
  Lattice lattice_;
  int reach_, reach_y_;
  Singles values_;
};

class BlockLu {
 public:
  BlockLu(const Lattice& lattice, int reach);

  /// Decomposes a matrix whose rows have a largest coefficient of one. free: cells whose rows may
  /// serve as pivots of each other. Returns whether the pivots of the other cells differ from zero.
  bool decompose(const NearMatrix& matrix, const std::vector<char>& free);
  /// Solves in place; x has a value for each cell.
  void solve(Singles& x);
  /// Numbers in the factors.
  double fill() const { return static_cast<double>(factors_.size()); }

 private:
  /// Adds the coefficients of the cells of a front to its matrix.
  void assemble(const NearMatrix& matrix, const Front& front, const DenseView& dense);
  /// Adds the Schur complement of a child.
  void extend(const Front& child, const float* complement, const DenseView& dense);
  /// Factors of a front: both triangles of its own cells, the rows of L below them, and the columns
  /// of U on their right, transposed.
  struct Parts {
    DenseView own, below, right;
  };
  Parts parts(std::size_t front);
  /// Stores the factors of a front, and its Schur complement.
  void store(const DenseView& dense, const Front& front, const Parts& to);

  Dissection order_;
  std::vector<int> cells_;           // at each place
  std::vector<std::size_t> begins_;  // of the factors of each front
  Singles factors_;
  std::vector<int> pivots_;     // row of its front that each place is exchanged with
  std::vector<int> exchanged_;  // of the present front
  std::vector<char> free_;
  std::vector<int> local_;  // row of each place in the present front
  Singles front_, stack_;   // present matrix; Schur complements that are not yet used
  Singles values_, part_;   // of the solution; of a front
};

}  // namespace samcontact::film
