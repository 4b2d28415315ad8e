// SPDX-License-Identifier: GPL-3.0-or-later
// Stress and surface displacement due to plastic strain in zones (small boxes of cells anywhere on
// an infinite lattice), at a cost proportional to the zones: docs/theory/zones.md.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/base/box_index.hpp"
#include "samcontact/operators/zones/low_bands.hpp"

namespace samcontact::operators {

/// Not thread-safe; uses several threads itself. Digits do not depend on their number.
class ZoneOperators {
 public:
  /// zones: disjoint boxes of cells, counted from the first cell of the grid, inside or outside the
  /// grid; the number of layers of the grid does not matter. Strain is [component][cell], the cells
  /// of one zone after the other, [k][i][j] each.
  ZoneOperators(std::shared_ptr<const ZoneTables> tables, std::vector<Box> zones);
  ~ZoneOperators();
  ZoneOperators(const ZoneOperators&) = delete;
  ZoneOperators& operator=(const ZoneOperators&) = delete;
  ZoneOperators(ZoneOperators&&) = delete;
  ZoneOperators& operator=(ZoneOperators&&) = delete;

  const std::vector<Box>& zones() const { return zones_; }
  std::size_t cells() const { return cells_; }

  /// Transforms the strain for the following calls: displacement along these axes, at least one,
  /// and stress.
  void transform(const Field& strain, std::span<const Axis> axes = normal_axis);
  /// Surface displacement [m] over the grid, [i][j], along one of these axes.
  void displacement(Axis axis, double* out) const;
  /// stress: [component][i][j] of a layer of a zone.
  using Use = std::function<void(std::size_t zone, int layer, const double* stress)>;
  /// Stress due to the transformed strain, which is passed again, or without strain (null), and to
  /// tractions on the grid: calls `use` in any order and from several threads. The transformed
  /// strain is then used up.
  void for_each_layer(const Field* strain, const Tractions& tractions, double shear_sign,
                      const Use& use);

 private:
  /// Zone with its margin, on a periodic plane.
  struct Around;

  void find_neighbours();
  std::size_t zone_of(int neighbour) const { return neighbour % zones_.size(); }
  void add_ring(int number);
  /// Transforms the strain of a zone, without that of others.
  void transform_zone(int zone, const Field& strain, std::span<const Axis> axes);
  /// Transformed strain of some neighbours on the plane around a zone. It is not kept from the
  /// displacement to the stress, as it needs several times the memory of the strain.
  VolumeSpectrum spectrum_around(const Around& around, std::span<const int> neighbours,
                                 const Field& strain) const;
  /// Whether a layer of a zone has strain in a box.
  bool has_strain(int neighbour, int k, const Field& strain, const Box& box) const;
  /// Layer of the strain in some neighbours, on the plane around a zone; buffer of this thread,
  /// valid until the next call.
  const double* strain_around(const Around& around, std::span<const int> neighbours, int k,
                              const Field& strain) const;
  void stress_of_zone(std::size_t zone, const Field* strain, const Tractions& tractions,
                      double shear_sign, const Use& use);
  /// Adds the displacement by the near band, due to a zone or to its image x, y cells away.
  void add_displacement(const Around& around, const double* of_zone, int x, int y,
                        double* out) const;

  std::shared_ptr<const ZoneTables> tables_;
  const Grid& grid_;
  std::vector<Box> zones_;
  std::vector<std::array<int, 2>> shifts_;  // of the images on a periodic surface; 0 first
  BoxIndex neighbours_;  // the zones in their order, then their images on a periodic surface
  std::vector<std::size_t> first_;  // number of cells before each zone
  std::size_t cells_ = 0;
  Tensor tensor_;
  LowBands low_;
  std::vector<Around> around_;
};

}  // namespace samcontact::operators
