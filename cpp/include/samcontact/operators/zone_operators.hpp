// SPDX-License-Identifier: GPL-3.0-or-later
// What plastic strain in zones, small boxes of cells anywhere on a lattice without ends, does there
// and to the surface, at the cost of the zones: docs/theory.md, "Zones".
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/operators/kernel_bands.hpp"
#include "samcontact/operators/node_spread.hpp"
#include "samcontact/operators/volume_operators.hpp"

namespace samcontact::operators {

/// Not thread-safe; several threads work inside. Digits do not depend on their number.
class ZoneOperators {
 public:
  /// zones: boxes of cells without common ones, counted from the grid's first cell, in the grid or
  /// beside it; layers of the grid do not matter. Strain is [component][cell], the cells of one
  /// zone after the other, [k][i][j] each.
  ZoneOperators(const Grid& grid, const SharedMedium& medium, std::vector<Box> zones, Tensor tensor,
                double image_tol);
  ~ZoneOperators();

  const std::vector<Box>& zones() const { return zones_; }
  std::size_t cells() const { return cells_; }

  /// Takes the strain for what follows.
  void transform(const Field& strain);
  /// Adds its u_z of the surface [m] over the grid, [i][j].
  void displacement(double* out);
  /// stress: [component][i][j] of a layer of a zone.
  using Use = std::function<void(int zone, int layer, const double* stress)>;
  /// Stress of the strain that was taken, if it is not null, and of tractions on the grid: calls
  /// use in any order, several at once. Ends the use of the strain.
  void for_each_layer(const Field* strain, const Tractions& tractions, double shear_sign,
                      const Use& use);

  std::size_t bytes() const;

 private:
  /// A zone with the ring around it, on a periodic plane.
  struct Around;
  struct Lattice;
  using NearOperators = std::shared_ptr<const VolumeOperators>;

  NearOperators near_operators(int mx, int my, int layers);
  Field ring_strain(const Around& around, const Field& strain) const;
  void stress_of_zone(int zone, const Field* strain, const Tractions& tractions, double shear_sign,
                      const Field& low, const Use& use) const;
  void spread_layer(int k, const Field& strain);
  /// What middle and far bands give in the zones, [component][cell].
  Field low_stress(bool strained, const Tractions& tractions, double shear_sign);

  Grid grid_;
  std::vector<Box> zones_;
  std::vector<std::size_t> first_;  // cells before each zone's
  std::size_t cells_ = 0;
  int layers_ = 0;
  Tensor tensor_;
  std::array<SharedMedium, 3> media_;
  std::vector<Around> around_;
  std::map<std::tuple<int, int, int>, NearOperators> near_;
  std::unique_ptr<Lattice> middle_, far_;
  Field far_strain_;                      // [component][k][node] of the far lattice
  std::vector<Field> near_displacement_;  // of each zone with its ring; empty: none
};

}  // namespace samcontact::operators
