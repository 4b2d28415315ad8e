// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint boxes of cells, and tiles of the lattice that the grid is a part of.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "samcontact/base/box.hpp"

namespace samcontact::simulation {

/// A cell of the lattice; it may lie beside the grid or below it.
struct Cell {
  int i, j, k;
  bool operator==(const Cell&) const = default;
};

/// Columns of the lattice, by 16 x 16: the first is that of the cells 0 to 15.
using Tile = std::pair<int, int>;
inline constexpr int tile_width = 16;
inline int tile_of(int i) { return i >= 0 ? i / tile_width : -((tile_width - 1 - i) / tile_width); }

/// Calls use(tile, part of the box in it) for each that a box has cells of.
template <class Use>
void for_each_tile(const Box& box, const Use& use) {
  if (box.empty()) return;
  const int i1 = tile_of(box.i0 + box.nx - 1), j1 = tile_of(box.j0 + box.ny - 1);
  for (int i = tile_of(box.i0); i <= i1; ++i) {
    for (int j = tile_of(box.j0); j <= j1; ++j) {
      const Box tile{i * tile_width, j * tile_width, tile_width, tile_width, box.nz};
      use(Tile{i, j}, tile.intersected(box));
    }
  }
}

/// Disjoint boxes, whose cells are numbered one box after the other, [zone][k][i][j]. Fields over
/// them are [component][cell].
class Zones {
 public:
  Zones() = default;
  explicit Zones(std::vector<Box> boxes);

  const std::vector<Box>& boxes() const { return boxes_; }
  std::size_t count() const { return boxes_.size(); }
  bool empty() const { return boxes_.empty(); }
  /// The smallest box that holds all of them.
  const Box& around() const { return around_; }
  std::size_t cells() const { return first_.back(); }
  /// Number of a zone's first cell.
  std::size_t first(std::size_t zone) const { return first_[zone]; }

  Cell cell(std::size_t number) const {
    const std::size_t zone = count() == 1 ? 0 : zone_of(number);
    const Box& box = boxes_[zone];
    const std::size_t n = number - first_[zone], ki = n / box.ny;
    return {box.i0 + static_cast<int>(ki % box.nx), box.j0 + static_cast<int>(n % box.ny),
            static_cast<int>(ki / box.nx)};
  }
  /// The reverse; -1 outside.
  std::ptrdiff_t number(const Cell& cell) const {
    return count() == 1 ? number_in(0, cell) : find(cell);
  }
  bool operator==(const Zones& other) const { return boxes_ == other.boxes_; }

  std::size_t zone_of(std::size_t number) const;

 private:
  std::ptrdiff_t number_in(std::size_t zone, const Cell& cell) const {
    const Box& box = boxes_[zone];
    const int i = cell.i - box.i0, j = cell.j - box.j0;
    if (i < 0 || i >= box.nx || j < 0 || j >= box.ny || cell.k >= box.nz) return -1;
    return static_cast<std::ptrdiff_t>(
        first_[zone] + (static_cast<std::size_t>(cell.k) * box.nx + i) * box.ny + j);
  }
  std::ptrdiff_t find(const Cell& cell) const;

  std::vector<Box> boxes_;
  std::vector<std::size_t> first_{0};  // and the number after the last
  Box around_;
  std::map<Tile, std::vector<std::size_t>> by_tile_;  // where there are several
};

/// The smallest box that holds all.
Box around(const std::vector<Box>& boxes);
/// Copies a field over the cells that both zones have; the rest of `to` stays.
void copy_common(const double* from, const Zones& from_zones, double* to, const Zones& to_zones);
/// Whether no two boxes have a cell in common.
bool are_disjoint(const std::vector<Box>& boxes);
/// Zones that hold all cells that lie in a box and in one of two others at least.
Zones covering(const Zones& a, const Zones& b, const Box& within);

}  // namespace samcontact::simulation
