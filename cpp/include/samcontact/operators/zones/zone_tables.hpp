// SPDX-License-Identifier: GPL-3.0-or-later
// What zones of one medium share: the tables of their planes, by band and size, and memory.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/fft/rows.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/kernel_bands.hpp"
#include "samcontact/operators/zones/node_spread.hpp"

namespace samcontact::operators {

/// A zone with the ring around it in which strain of others acts on it through the near band: wider
/// at sides beyond which some are close, since what is cut off there lies beside strain as strong.
Box with_ring(const Box& zone, const std::vector<Box>& zones, const BandSplit& split);

/// The planes of a band's nodes. Where a surface repeats itself their ends are joined: spreading
/// and gathering then take a sheet that goes on beyond them, else it is the plane.
class NodePlanes {
 public:
  /// lattice: of the operators on the planes.
  NodePlanes(NodeSpread nodes, const Grid& lattice, bool joined);

  const NodeSpread& nodes() const { return nodes_; }
  const Grid& lattice() const { return lattice_; }
  std::size_t plane_size() const { return lattice_.surface_size(); }
  /// The nodes of a sheet: its rows are as long as the box.
  const Box& sheet() const { return sheet_; }
  std::size_t sheet_size() const { return sheet_.surface_size(); }
  /// The nodes of a plane that a coarser lattice takes, in rows of pitch() numbers.
  Box own() const;
  int pitch() const { return lattice_.ny; }
  bool is_joined() const { return joined_; }
  /// Adds a sheet to the plane, with what it has beyond the ends, where these are joined.
  void fold(const double* sheet, double* plane) const;
  /// The sheet of a plane, in `room` where they differ.
  const double* sheet_of(const double* plane, Field& room) const;
  /// Adds what the cells of a box, in rows of `pitch` numbers, give to the plane.
  void spread(const double* cells, int pitch, const Box& box, double* plane) const;
  /// Rows of the plane that some boxes of its nodes hold.
  std::vector<fft::RowRun> rows_of(const std::vector<Box>& boxes) const;

 private:
  NodeSpread nodes_;
  Grid lattice_;
  bool joined_;
  Box sheet_;
};

/// Tractions on the cells of a box, or on nodes, in rows of `pitch` numbers, on the planes of a
/// lattice.
Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodePlanes& planes);

/// Whether the operators on a grid can be split in bands: where it repeats itself, it does so along
/// x and y, in whole far nodes.
bool can_be_split(const Grid& grid, const BandSplit& split);

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
  const SharedMedium& medium(Band band) const { return bands_[static_cast<int>(band)].medium; }
  /// Null: none.
  const std::shared_ptr<const HeatStress>& heat(Band band) const {
    return heat_[static_cast<int>(band)];
  }
  bool is_joined() const { return grid_.period.is_on(); }
  /// What the cells of a box reach, and of those what reaches far nodes; of so many layers.
  NodePlanes middle_planes(const Box& cells, int layers) const;
  NodePlanes far_planes(const NodePlanes& middle, int layers) const;
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
  NodePlanes planes(Band band, NodeSpread nodes, int layers) const;

  Grid grid_;
  Tensor tensor_;
  double image_tol_;
  BandSplit split_;
  std::array<MediumBand, 3> bands_;
  std::array<std::shared_ptr<const HeatStress>, 3> heat_;
  mutable std::mutex mutex_;
  mutable std::map<std::array<int, 4>, Operators> kept_;
  mutable std::vector<Field> spare_;  // the smallest first
};

}  // namespace samcontact::operators
