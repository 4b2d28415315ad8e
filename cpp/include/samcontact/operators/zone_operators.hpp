// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in zones, small boxes of cells anywhere on a lattice without ends, does there
// and to the surface, at the cost of the zones: docs/theory.md, "Zones".
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/operators/zone_tables.hpp"

namespace samcontact::operators {

/// Not thread-safe; several threads work inside. Digits do not depend on their number.
class ZoneOperators {
 public:
  /// zones: boxes of cells without common ones, counted from the grid's first cell, in the grid or
  /// beside it; layers of the grid do not matter. Strain is [component][cell], the cells of one
  /// zone after the other, [k][i][j] each.
  ZoneOperators(std::shared_ptr<const ZoneTables> tables, std::vector<Box> zones);
  ~ZoneOperators();
  ZoneOperators(const ZoneOperators&) = delete;
  ZoneOperators& operator=(const ZoneOperators&) = delete;
  ZoneOperators(ZoneOperators&&) = delete;
  ZoneOperators& operator=(ZoneOperators&&) = delete;

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
  /// Of the lattices' planes, which ones zones read.
  void find_rows();
  void add_ring(const Box& zone);
  /// Takes the strain of a zone, without that of others.
  void transform_zone(int zone, const Field& strain, std::span<const Axis> axes);
  /// To what was taken of a zone, the strain of others in its ring; null: none at all.
  void add_others(std::size_t zone, const Field* strain);
  /// Whether a layer of a zone has strain in a box.
  bool has_strain(int zone, int k, const Field& strain, const Box& box) const;
  /// A layer of the strain in some zones, on the plane around one; of this thread, until it asks
  /// again.
  const double* strain_around(const Around& around, std::span<const int> zones, int k,
                              const Field& strain) const;
  void stress_of_zone(std::size_t zone, const Field* strain, const Tractions& tractions,
                      double shear_sign, const Use& use);
  void spread_layer(int k, const Field& strain);
  /// Adds what planes of far and middle nodes give to the cells of a box, one layer.
  void gather_low(const double* far, const double* middle, const Box& box, double* cells) const;
  void find_low_stress(bool strained, const Tractions& tractions, double shear_sign);

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
  Field far_stress_;  // [k][component][node]
  Field low_;         // what middle and far bands give in the zones, [component][cell]
};

}  // namespace samcontact::operators
