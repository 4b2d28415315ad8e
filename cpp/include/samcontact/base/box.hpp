// SPDX-License-Identifier: GPL-3.0-or-later
// Box of cells: a rectangle of surface cells and layers below it, counted from the surface down.
#pragma once

#include <algorithm>
#include <cstddef>

#include "samcontact/base/grid.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact {

struct Box {
  int i0 = 0, j0 = 0;  // first cell of the rectangle
  int nx = 0, ny = 0, nz = 0;
  int k0 = 0;  // first layer; nz is the number of layers from the surface to its bottom

  static Box whole(const Grid& grid) { return {0, 0, grid.nx, grid.ny, grid.nz}; }
  /// The whole surface as a single layer.
  static Box surface(const Grid& grid) { return {0, 0, grid.nx, grid.ny, 1}; }

  /// Its rectangle as a single layer.
  Box layer() const { return {i0, j0, nx, ny, 1}; }

  bool empty() const { return nx == 0 || ny == 0; }
  bool operator==(const Box&) const = default;
  std::size_t surface_size() const { return static_cast<std::size_t>(nx) * ny; }
  int layers() const { return nz - k0; }
  std::size_t volume_size() const { return surface_size() * layers(); }
  /// Grid of the cells of the box.
  Grid grid(const Grid& of) const {
    Grid part{nx, ny, of.dx, of.dy, layers(), of.dz};
    part.period = of.period;
    part.k0 = k0;
    return part;
  }

  Box moved(int along_x, int along_y) const { return {i0 + along_x, j0 + along_y, nx, ny, nz, k0}; }
  /// The box and all layers above it.
  Box from_surface() const { return {i0, j0, nx, ny, nz}; }
  bool contains(const Box& other) const;
  /// Cells that both boxes contain; empty if there are none.
  Box intersected(const Box& other) const;
  /// Smallest box that contains both boxes; an empty box contributes its depth only, and one
  /// without layers its rectangle only.
  Box united(const Box& other) const;
};

/// Smallest single-layer box around the surface cells whose index satisfies the predicate.
template <class Pick>
Box bounding_box(const Grid& grid, const Pick& pick) {
  int i0 = grid.nx, i1 = -1, j0 = grid.ny, j1 = -1;
#pragma omp parallel for schedule(static) reduction(min : i0, j0) reduction( \
        max : i1, j1) if (static_cast<std::ptrdiff_t>(grid.nx) * grid.ny >= min_parallel_cells)
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      if (!pick(static_cast<std::size_t>(i) * grid.ny + j)) continue;
      i0 = std::min(i0, i);
      i1 = std::max(i1, i);
      j0 = std::min(j0, j);
      j1 = std::max(j1, j);
    }
  }
  if (i1 < 0) return {};
  return {i0, j0, i1 - i0 + 1, j1 - j0 + 1, 1};
}

/// Copies layers [k][i][j] between a box and another box that contains it.
void insert(const double* small, const Box& from, double* large, const Box& into);
void extract(const double* large, const Box& from, double* small, const Box& into);
/// Copies the values in cells that both boxes contain; the rest of `to` is unchanged.
void copy_common(const double* from, const Box& from_box, double* to, const Box& to_box);

}  // namespace samcontact
