// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in zones, small boxes of cells anywhere on a lattice without ends, does there
// and to the surface, at the cost of the zones: docs/theory/zones.md.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/operators/zones/low_bands.hpp"

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
  /// A zone, or an image of it where the surface repeats itself.
  struct Neighbour {
    Box box{};
    int zone = 0;
  };

  /// The zones first, as they are numbered.
  void find_neighbours();
  void add_ring(int number);
  /// Takes the strain of a zone, without that of others.
  void transform_zone(int zone, const Field& strain, std::span<const Axis> axes);
  /// To what was taken of a zone, the strain of others in its ring; null: none at all.
  void add_others(std::size_t zone, const Field* strain);
  /// Whether a layer of a zone has strain in a box.
  bool has_strain(const Neighbour& neighbour, int k, const Field& strain, const Box& box) const;
  /// A layer of the strain in some neighbours, on the plane around a zone; of this thread, until it
  /// asks again.
  const double* strain_around(const Around& around, std::span<const int> neighbours, int k,
                              const Field& strain) const;
  void stress_of_zone(std::size_t zone, const Field* strain, const Tractions& tractions,
                      double shear_sign, const Use& use);
  /// Adds the displacement by the near band, of a zone or of its image so many cells away.
  void add_displacement(const Around& around, const double* of_zone, int x, int y,
                        double* out) const;

  std::shared_ptr<const ZoneTables> tables_;
  const Grid& grid_;
  std::vector<Box> zones_;
  std::vector<std::array<int, 2>> shifts_;  // by which the surface repeats itself; 0 first
  std::vector<Neighbour> neighbours_;
  std::vector<std::size_t> first_;  // cells before each zone's
  std::size_t cells_ = 0;
  Tensor tensor_;
  LowBands low_;
  std::vector<Around> around_;
};

}  // namespace samcontact::operators
