// SPDX-License-Identifier: GPL-3.0-or-later
// Spreading from cells to the nodes of a coarser lattice and gathering, with the window of Barnett,
// Magland & af Klinteberg (2019), doi:10.1137/18M120885X: fields that are smooth on the lattice are
// transferred as if sampled, once the spectrum between the two steps is divided by the square of
// the transform of the window.
#pragma once

#include <utility>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"

namespace samcontact::operators {

/// Transform of the window over a number of nodes.
class WindowTransform {
 public:
  explicit WindowTransform(int width);
  /// Value at a wavenumber in 1/node.
  double operator()(double k) const;

 private:
  std::vector<std::pair<double, double>> points_;  // nodes and weights of one half
};

/// Nodes along one axis, an even number `factor` of cells apart: node a lies in the middle of the
/// cells a factor .. (a + 1) factor - 1.
class Nodes {
 public:
  /// All nodes of the cells first, .., first + cells - 1; each cell has `width` nodes: 4, 6, 8
  /// or 10.
  Nodes(int factor, int width, int first_cell, int cells);

  int first() const { return first_; }
  int count() const { return count_; }
  /// First node of a cell, counted from first(), and the weights from it on.
  int place(int cell) const;
  const double* weights(int cell) const;
  int width() const { return width_; }
  /// Spreads from cells to nodes, and gathers from nodes to cells (adding): one line, its first
  /// cell and first node.
  void spread(const double* cells, int first_cell, int count, double* nodes) const;
  void gather(const double* nodes, int first_cell, int count, double* cells) const;

 private:
  struct Phase {
    int shift;
    Field weights;
  };
  int factor_, width_, first_, count_;
  std::vector<Phase> phases_;
};

/// Spreading along both axes. Rows of planes [i][j] of cells and [a][b] of nodes may be longer than
/// their content: the pitch is the length of a row.
class NodeSpread {
 public:
  /// All nodes of the cells of a box.
  NodeSpread(int factor, int width, const Box& cells);

  const Nodes& x() const { return x_; }
  const Nodes& y() const { return y_; }
  /// All nodes, as cells of another lattice.
  Box box() const { return {x_.first(), y_.first(), x_.count(), y_.count(), 1}; }
  /// Adds the contribution of the cells of a box to the nodes.
  void spread(const double* cells, int cell_pitch, const Box& box, double* nodes, int pitch) const;
  /// Adds the contribution of nodes, a plane over the box `of` that contains all required nodes, to
  /// the cells of a box.
  void gather(const double* nodes, const Box& of, const Box& box, double* cells) const;
  /// Gathers at every factor-th cell from cell 0 on, whose weights are all equal, [i][j]; nodes is
  /// a plane over box().
  void gather_first(const double* nodes, int nx, int ny, double* cells) const;
  /// Nodes of the cells of a box, as cells of another lattice.
  Box reached(const Box& box) const;

 private:
  Nodes x_, y_;
};

}  // namespace samcontact::operators
