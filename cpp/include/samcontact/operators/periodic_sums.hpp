// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of influence coefficients on periodic grids, for any offsets: folded into one period, and
// with x and y exchanged where the tables ask for it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "samcontact/operators/heating.hpp"
#include "samcontact/operators/periodic_table.hpp"
#include "samcontact/operators/tractions.hpp"

namespace samcontact::operators {

enum class Axis { x, y, z };

/// With x and y exchanged.
Traction exchanged(Traction traction);
Axis exchanged(Axis axis);
Grid exchanged(const Grid& grid);
/// Where the components xx, yy, zz, yz, xz, xy then are.
inline constexpr std::array<int, 6> exchanged_components{1, 0, 2, 4, 3, 5};

/// Offsets of a table in cells of the grid, not negative, in any order; they may skip cells.
struct CellOffsets {
  std::vector<int> x, y;

  static CellOffsets lattice(int nx, int ny);
  Offsets in_metres(double dx, double dy) const;
};

/// Thread-safe. Keeps what the last grid needed.
class PeriodicSums {
 public:
  /// The influence of one cell of a grid, of the grid's own axes or of the exchanged ones.
  using Make = std::function<CellInfluence(const Grid& grid, bool exchanged)>;

  /// Tables [component][j][i] on a periodic grid. order: of the components once exchanged.
  Field sum(const Grid& grid, const CellOffsets& offsets, const Make& make,
            std::span<const int> order) const;

 private:
  std::shared_ptr<const PeriodicTable> table(const Grid& grid, int cells_x) const;

  mutable std::mutex mutex_;
  mutable std::shared_ptr<const PeriodicTable> kept_;
};

}  // namespace samcontact::operators
