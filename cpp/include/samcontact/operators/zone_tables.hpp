// SPDX-License-Identifier: GPL-3.0-or-later
// What zones of one medium share: the tables of their planes, by band and size, and memory.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/kernel_bands.hpp"
#include "samcontact/operators/node_spread.hpp"
#include "samcontact/operators/volume_operators.hpp"

namespace samcontact::operators {

/// A zone with the ring around it in which strain of others acts on it through the near band: wider
/// at sides beyond which some are close, since what is cut off there lies beside strain as strong.
Box with_ring(const Box& zone, const std::vector<Box>& zones, const BandSplit& split);

/// The tables that zones of one medium need, kept from one set of zones to the next. Thread-safe.
class ZoneTables {
 public:
  using Operators = std::shared_ptr<const VolumeOperators>;

  /// heating: that goes with the pressure.
  ZoneTables(const Grid& grid, const SharedMedium& medium, Tensor tensor, double image_tol,
             const BandSplit& split = {}, const Heating& heating = {});

  const Grid& grid() const { return grid_; }
  Tensor tensor() const { return tensor_; }
  const BandSplit& split() const { return split_; }
  const SharedMedium& medium(Band band) const { return media_[static_cast<int>(band)]; }
  /// Null: none.
  const std::shared_ptr<const HeatStress>& heat(Band band) const {
    return heat_[static_cast<int>(band)];
  }
  /// What the cells of a box reach, and of those what reaches far nodes.
  NodeSpread middle_nodes(const Box& cells) const;
  NodeSpread far_nodes(const NodeSpread& middle) const;
  /// The planes of some nodes of a band, and so many layers.
  Grid lattice(Band band, const NodeSpread& nodes, int layers) const;
  /// On a lattice; of some layers more than it has.
  Operators of(Band band, Grid lattice) const;
  /// Those that nobody uses go.
  void forget_unused() const;
  /// Some numbers, given back for the next set of zones: large fields the system would clear page
  /// by page each time.
  Field borrow(std::size_t count) const;
  void give_back(Field field) const;
  /// Of the tables, not of what is lent: that depends on what was solved before.
  std::size_t bytes() const;

 private:
  Grid grid_;
  Tensor tensor_;
  double image_tol_;
  BandSplit split_;
  std::array<SharedMedium, 3> media_;
  std::array<std::shared_ptr<const HeatStress>, 3> heat_;
  mutable std::mutex mutex_;
  mutable std::map<std::array<int, 4>, Operators> kept_;
  mutable std::vector<Field> spare_;  // the smallest first
};

/// Tractions on the cells of a box, or on nodes, in rows of `pitch` numbers, on the nodes of a
/// lattice.
Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodeSpread& nodes,
                 const Grid& lattice);

}  // namespace samcontact::operators
