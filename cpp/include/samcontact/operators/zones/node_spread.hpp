// SPDX-License-Identifier: GPL-3.0-or-later
// From cells to the nodes of a coarser lattice and back, with the window of Barnett, Magland & af
// Klinteberg (2019), doi:10.1137/18M120885X: what is smooth on the lattice passes as if it were
// sampled, once the spectrum between the two is divided by the square of the window's transform.
#pragma once

#include <utility>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"

namespace samcontact::operators {

/// Transform of the window over so many nodes.
class WindowTransform {
 public:
  explicit WindowTransform(int width);
  /// At a wavenumber in 1/node.
  double operator()(double k) const;

 private:
  std::vector<std::pair<double, double>> points_;  // nodes and weights of one half
};

/// Nodes along one axis, an even number `factor` of cells apart: node a lies in the middle of the
/// cells a factor .. (a + 1) factor - 1.
class Nodes {
 public:
  /// All that the cells first, .., first + cells - 1 reach, each `width` of them: 4, 6, 8 or 10.
  Nodes(int factor, int width, int first_cell, int cells);

  int first() const { return first_; }
  int count() const { return count_; }
  /// The first one that a cell reaches, counted from first(), and the weights from it on.
  int place(int cell) const;
  const double* weights(int cell) const;
  int width() const { return width_; }
  /// Adds what cells give to nodes, and nodes to cells: one line, the first cell and its first
  /// node.
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

/// Both axes. Rows of planes [i][j] of cells and [a][b] of nodes may be longer than what is in
/// them: a pitch is the numbers of a row.
class NodeSpread {
 public:
  /// All nodes that the cells of a box reach.
  NodeSpread(int factor, int width, const Box& cells);

  const Nodes& x() const { return x_; }
  const Nodes& y() const { return y_; }
  /// All nodes, as cells of another lattice.
  Box box() const { return {x_.first(), y_.first(), x_.count(), y_.count(), 1}; }
  /// Adds what the cells of a box give to the nodes.
  void spread(const double* cells, int cell_pitch, const Box& box, double* nodes, int pitch) const;
  /// Adds what nodes, a plane over the box `of` that has all which are reached, give to the cells
  /// of a box.
  void gather(const double* nodes, const Box& of, const Box& box, double* cells) const;
  /// The same of every factor-th cell from cell 0 on, whose weights are all alike, [i][j]; nodes is
  /// a plane over box().
  void gather_first(const double* nodes, int nx, int ny, double* cells) const;
  /// The nodes that the cells of a box reach, as cells of another lattice.
  Box reached(const Box& box) const;

 private:
  Nodes x_, y_;
};

}  // namespace samcontact::operators
