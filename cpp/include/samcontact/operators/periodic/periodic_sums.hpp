// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of influence coefficients on periodic grids, for any offsets: folded into one period, and
// with x and y exchanged if the tables require it.
#pragma once

#include <array>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "samcontact/operators/influence/offsets.hpp"
#include "samcontact/operators/influence/tractions.hpp"
#include "samcontact/operators/periodic/periodic_table.hpp"

namespace samcontact::operators {

/// Traction after x and y are exchanged.
Traction exchanged(Traction traction);
Axis exchanged(Axis axis);
Grid exchanged(const Grid& grid);
/// Positions of the components xx, yy, zz, yz, xz, xy after the exchange.
inline constexpr std::array<int, 6> exchanged_components{1, 0, 2, 4, 3, 5};

/// Thread-safe. Caches the data of the last grids, and the sums of named influences.
class PeriodicSums {
 public:
  /// Influence of one cell of a grid, on the axes of the grid or on exchanged axes.
  using Make = std::function<CellInfluence(const Grid& grid, bool exchanged)>;

  /// Tables [component][j][i] on a periodic grid. order: order of the components after an exchange.
  /// name: number, not negative, of an influence that is needed again. step: factor by which the
  /// grid is coarser than the cell; a uniform load is then a load on one cell at each position of
  /// the coarser grid.
  Field sum(const Grid& grid, const CellOffsets& offsets, const Make& make,
            std::span<const int> order, int name = -1, int step = 1) const;

 private:
  struct Named {
    int name;
    std::shared_ptr<const PeriodicTable> table;
    std::shared_ptr<const Field> sums;
  };
  std::shared_ptr<const PeriodicTable> table(const Grid& grid, int cells_x, int step) const;
  std::shared_ptr<const Field> sums(const std::shared_ptr<const PeriodicTable>& table,
                                    const CellInfluence& influence, int name) const;

  mutable std::mutex mutex_, named_mutex_;
  mutable std::list<std::shared_ptr<const PeriodicTable>> tables_;  // most recently used first
  mutable std::list<Named> named_;
};

}  // namespace samcontact::operators
