// SPDX-License-Identifier: GPL-3.0-or-later
// Middle and far bands of zones: stress and displacement due to strain in zones and to tractions,
// on the nodes of two lattices over the whole surface.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/operators/zones/zone_tables.hpp"

namespace samcontact::operators {

/// Not thread-safe; uses several threads itself. Digits do not depend on their number.
class LowBands {
 public:
  /// zones, strain: as in ZoneOperators.
  LowBands(std::shared_ptr<const ZoneTables> tables, const std::vector<Box>& zones);
  ~LowBands();
  LowBands(const LowBands&) = delete;
  LowBands& operator=(const LowBands&) = delete;
  LowBands(LowBands&&) = delete;
  LowBands& operator=(LowBands&&) = delete;

  /// Transforms the strain, for the following calls.
  void transform(const Field& strain);
  /// Adds the surface displacement due to the transformed strain [m] over the grid, [i][j].
  void add_displacement(Axis axis, double* out) const;
  /// Stress due to the transformed strain, or without strain, and to tractions on the grid. The
  /// transformed strain is then used up.
  void find_stress(bool strained, const Tractions& tractions, double shear_sign);
  /// Stress in a layer of a zone: [component][i][j] [Pa]. Thread-safe.
  void stress(std::size_t zone, int layer, double* out) const;
  /// Returns most of the memory to the tables until the next call of transform() or find_stress().
  void lend();

 private:
  struct Lattice;

  void take_back();
  /// Finds the rows of the lattice planes that zones read.
  void find_rows();
  void spread_layer(int k, const Field& strain);

  std::shared_ptr<const ZoneTables> tables_;
  const Grid& grid_;
  const std::vector<Box>& zones_;
  std::vector<std::size_t> first_;  // number of cells before each zone
  std::size_t cells_ = 0;
  int layers_ = 0;
  Tensor tensor_;
  std::unique_ptr<Lattice> middle_, far_;
  Field far_strain_;  // [component][k][node] of the far lattice
};

/// Zero-initialised numbers of the calling thread, reused between calls.
double* of_zeros(std::size_t count);

}  // namespace samcontact::operators
