// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint boxes of cells (zones), and tiles of the lattice that contains the grid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "samcontact/base/box.hpp"

namespace samcontact::simulation {

/// Cell of the lattice; it may lie beyond the edges of the grid or below it.
struct Cell {
  int i, j, k;
  bool operator==(const Cell&) const = default;
};

/// Tile of 16 x 16 columns of the lattice: the first one contains the cells 0 to 15.
using Tile = std::pair<int, int>;
inline constexpr int tile_width = 16;
inline int tile_of(int i) { return i >= 0 ? i / tile_width : -((tile_width - 1 - i) / tile_width); }

/// Calls use(tile, part of the box in it) for each tile that contains cells of a box.
template <class Use>
void for_each_tile(const Box& box, const Use& use) {
  if (box.empty()) return;
  const int i1 = tile_of(box.i0 + box.nx - 1), j1 = tile_of(box.j0 + box.ny - 1);
  for (int i = tile_of(box.i0); i <= i1; ++i) {
    for (int j = tile_of(box.j0); j <= j1; ++j) {
      const Box tile{i * tile_width, j * tile_width, tile_width, tile_width, box.nz, box.k0};
      use(Tile{i, j}, tile.intersected(box));
    }
  }
}

/// Disjoint boxes; their cells are numbered box by box, [zone][k][i][j]. Fields over them are
/// [component][cell].
class Zones {
 public:
  Zones() = default;
  explicit Zones(std::vector<Box> boxes);

  const std::vector<Box>& boxes() const { return boxes_; }
  std::size_t count() const { return boxes_.size(); }
  bool empty() const { return boxes_.empty(); }
  /// Smallest box around all zones.
  const Box& around() const { return around_; }
  std::size_t cells() const { return first_.back(); }
  /// Index of the first cell of a zone.
  std::size_t first(std::size_t zone) const { return first_[zone]; }

  Cell cell(std::size_t number) const {
    const std::size_t zone = count() == 1 ? 0 : zone_of(number);
    const Box& box = boxes_[zone];
    const std::size_t n = number - first_[zone], ki = n / box.ny;
    return {box.i0 + static_cast<int>(ki % box.nx), box.j0 + static_cast<int>(n % box.ny),
            box.k0 + static_cast<int>(ki / box.nx)};
  }
  /// Index of a cell; -1 outside the zones.
  std::ptrdiff_t number(const Cell& cell) const {
    return count() == 1 ? number_in(0, cell) : find(cell);
  }
  bool operator==(const Zones& other) const { return boxes_ == other.boxes_; }

  std::size_t zone_of(std::size_t number) const;

 private:
  std::ptrdiff_t number_in(std::size_t zone, const Cell& cell) const {
    const Box& box = boxes_[zone];
    const int i = cell.i - box.i0, j = cell.j - box.j0;
    if (i < 0 || i >= box.nx || j < 0 || j >= box.ny) return -1;
    if (cell.k < box.k0 || cell.k >= box.nz) return -1;
    return static_cast<std::ptrdiff_t>(
        first_[zone] + (static_cast<std::size_t>(cell.k - box.k0) * box.nx + i) * box.ny + j);
  }
  std::ptrdiff_t find(const Cell& cell) const;

  std::vector<Box> boxes_;
  std::vector<std::size_t> first_{0};  // and the index after the last cell
  Box around_;
  std::map<Tile, std::vector<std::size_t>> by_tile_;  // if there are several zones
};

/// Smallest box around all boxes.
Box around(const std::vector<Box>& boxes);
/// Copies a field over the cells common to both zones; the rest of `to` is unchanged.
void copy_common(const double* from, const Zones& from_zones, double* to, const Zones& to_zones);
/// Whether no two boxes have a common cell.
bool are_disjoint(const std::vector<Box>& boxes);
/// Zones that contain all cells that lie in a box and in at least one of two other sets of zones.
Zones covering(const Zones& a, const Zones& b, const Box& within);

}  // namespace samcontact::simulation
