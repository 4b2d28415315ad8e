// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in zones, small boxes of cells anywhere on a lattice without ends, does there
// and to the surface, at the cost of the zones: docs/theory.md, "Zones".
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/kernel_bands.hpp"
#include "samcontact/operators/node_spread.hpp"
#include "samcontact/operators/volume_operators.hpp"

namespace samcontact::operators {

/// The tables that zones of one medium need, kept from one set of zones to the next. Thread-safe.
class ZoneTables {
 public:
  using Operators = std::shared_ptr<const VolumeOperators>;

  ZoneTables(const Grid& grid, const SharedMedium& medium, Tensor tensor, double image_tol);

  const Grid& grid() const { return grid_; }
  Tensor tensor() const { return tensor_; }
  const SharedMedium& medium(Band band) const { return media_[static_cast<int>(band)]; }
  /// The planes of some nodes of a band, and so many layers.
  Grid lattice(Band band, const NodeSpread& nodes, int layers) const;
  /// On a lattice; of some layers more than it has.
  Operators of(Band band, Grid lattice) const;
  /// Those that nobody uses go.
  void forget_unused() const;
  std::size_t bytes() const;

 private:
  Grid grid_;
  Tensor tensor_;
  double image_tol_;
  std::array<SharedMedium, 3> media_;
  mutable std::mutex mutex_;
  mutable std::map<std::array<int, 4>, Operators> kept_;
};

/// Tractions on the cells of a box, or on nodes, in rows of `pitch` numbers, on the nodes of a
/// lattice.
Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodeSpread& nodes,
                 const Grid& lattice);

/// Not thread-safe; several threads work inside. Digits do not depend on their number.
class ZoneOperators {
 public:
  /// zones: boxes of cells without common ones, counted from the grid's first cell, in the grid or
  /// beside it; layers of the grid do not matter. Strain is [component][cell], the cells of one
  /// zone after the other, [k][i][j] each.
  ZoneOperators(std::shared_ptr<const ZoneTables> tables, std::vector<Box> zones);
  ~ZoneOperators();

  const std::vector<Box>& zones() const { return zones_; }
  std::size_t cells() const { return cells_; }

  /// Takes the strain for what follows: displacement along these axes, at least one, and stress.
  void transform(const Field& strain, std::span<const Axis> axes = normal_axis);
  /// Its displacement of the surface [m] over the grid, [i][j], along one of these.
  void displacement(Axis axis, double* out) const;
  /// stress: [component][i][j] of a layer of a zone.
  using Use = std::function<void(std::size_t zone, int layer, const double* stress)>;
  /// Stress of the strain, which is the one that was taken, or none (null), and of tractions on the
  /// grid: calls use in any order, several at once. What was taken is then used up.
  void for_each_layer(const Field* strain, const Tractions& tractions, double shear_sign,
                      const Use& use);

 private:
  /// A zone with the ring around it, on a periodic plane.
  struct Around;
  struct Lattice;

  void make_lattices();
  void add_ring(const Box& zone);
  /// Of the first layers of the strain in some zones, on the plane around one.
  VolumeSpectrum spectrum_around(const Around& around, const std::vector<int>& zones, int layers,
                                 const Field& strain) const;
  /// A layer of that strain; of this thread, until it asks again.
  const double* strain_around(const Around& around, const std::vector<int>& zones, int k,
                              const Field& strain) const;
  void stress_of_zone(std::size_t zone, const Field* strain, const Tractions& tractions,
                      double shear_sign, const Field& low, const Use& use);
  void spread_layer(int k, const Field& strain);
  /// Adds what planes of far and middle nodes give to the cells of a box, one layer.
  void gather_low(const double* far, const double* middle, const Box& box, double* cells) const;
  /// What middle and far bands give in the zones, [component][cell].
  Field low_stress(bool strained, const Tractions& tractions, double shear_sign);

  std::shared_ptr<const ZoneTables> tables_;
  const Grid& grid_;
  std::vector<Box> zones_;
  std::vector<std::size_t> first_;  // cells before each zone's
  std::size_t cells_ = 0;
  int layers_ = 0;
  Tensor tensor_;
  std::vector<Around> around_;
  std::unique_ptr<Lattice> middle_, far_;
  Field far_strain_;  // [component][k][node] of the far lattice
};

}  // namespace samcontact::operators
