// SPDX-License-Identifier: GPL-3.0-or-later
// Data shared by the zones of one medium: tables of their planes, by band and size, and work
// memory.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "samcontact/base/box_index.hpp"
#include "samcontact/fft/rows.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/kernel_bands.hpp"
#include "samcontact/operators/zones/node_spread.hpp"

namespace samcontact::operators {

/// Zone with the margin in which strain of other zones acts on it through the near band: wider at
/// sides with other zones nearby, because the truncated part is next to equally strong strain.
Box zone_with_margin(const Box& zone, const std::vector<Box>& zones, const BandSplit& split);
Box zone_with_margin(const Box& zone, const BoxIndex& zones, const BandSplit& split);

/// Planes of the nodes of a band. On a periodic surface their ends are joined: spreading and
/// gathering then use a sheet that extends beyond the ends; otherwise the sheet is the plane.
class NodePlanes {
 public:
  /// lattice: of the operators on the planes. periodic: whether the ends are joined.
  NodePlanes(NodeSpread nodes, const Grid& lattice, bool periodic);

  const NodeSpread& nodes() const { return nodes_; }
  const Grid& lattice() const { return lattice_; }
  std::size_t plane_size() const { return lattice_.surface_size(); }
  /// Nodes of the sheet: its rows are as long as the box.
  const Box& sheet() const { return sheet_; }
  std::size_t sheet_size() const { return sheet_.surface_size(); }
  /// Nodes of a plane that a coarser lattice uses, in rows of pitch() numbers.
  Box own() const;
  int pitch() const { return lattice_.ny; }
  bool is_periodic() const { return periodic_; }
  /// Calls use(first value of the box, first value of the plane, number of values) for each piece
  /// of the rows of a box in the sheet that is contiguous in the plane.
  using UsePiece = std::function<void(std::size_t in_box, std::size_t in_plane, int count)>;
  void for_each_piece(const Box& box, const UsePiece& use) const;
  /// Adds a sheet to the plane, including the parts beyond joined ends.
  void fold(const double* sheet, double* plane) const;
  /// Sheet of a plane, in `room` if they differ.
  const double* sheet_of(const double* plane, Field& room) const;
  /// Adds the contribution of the cells of a box, in rows of `pitch` numbers, to the plane.
  void spread(const double* cells, int pitch, const Box& box, double* plane) const;
  /// Rows of the plane that contain the given boxes of its nodes.
  std::vector<fft::RowRun> rows_of(const std::vector<Box>& boxes) const;

 private:
  NodeSpread nodes_;
  Grid lattice_;
  bool periodic_;
  Box sheet_;
};

/// Tractions on the cells of a box, or on nodes, in rows of `pitch` numbers, spread to the planes
/// of a lattice.
Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodePlanes& planes);

/// Whether the operators on a grid can be split into bands: a periodic grid must be periodic along
/// x and y, with whole far nodes.
bool can_be_split(const Grid& grid, const BandSplit& split);

/// Tables for the zones of one medium, cached from one set of zones to the next. Thread-safe.
class ZoneTables {
 public:
  using Operators = std::shared_ptr<const VolumeOperators>;

  /// heating: proportional to the pressure.
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
  bool is_periodic() const { return grid_.period.is_on(); }
  /// Planes of the middle nodes of the cells of a box, and of the far nodes of these; with the
  /// given number of layers.
  NodePlanes middle_planes(const Box& cells, int layers) const;
  NodePlanes far_planes(const NodePlanes& middle, int layers) const;
  /// Operators on a lattice, with some more layers.
  Operators of(Band band, Grid lattice) const;
  /// Releases the tables that are not in use.
  void forget_unused() const;
  /// Number array, to be returned for the next set of zones: the system would clear large new
  /// arrays page by page each time.
  Field borrow(std::size_t count) const;
  /// Spectrum in a borrowed array, with its content.
  VolumeSpectrum borrow_spectrum(const VolumeTransform& transform, int layers, Tensor tensor) const;
  void give_back(Field field) const;
  /// Memory of the tables [byte], without lent arrays, whose number depends on earlier solutions.
  std::size_t bytes() const;
  /// Memory of the tables and of the arrays that are not lent [byte].
  std::size_t held_bytes() const;

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
  mutable std::vector<Field> spare_;  // smallest first
};

}  // namespace samcontact::operators
