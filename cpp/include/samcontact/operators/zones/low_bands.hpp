// SPDX-License-Identifier: GPL-3.0-or-later
// The middle and the far band of zones: what strain in zones and tractions do by them, on the nodes
// of two lattices over all of the surface.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/operators/zones/zone_tables.hpp"

namespace samcontact::operators {

/// Not thread-safe; several threads work inside. Digits do not depend on their number.
class LowBands {
 public:
  /// zones, strain: as those of ZoneOperators.
  LowBands(std::shared_ptr<const ZoneTables> tables, const std::vector<Box>& zones);
  ~LowBands();
  LowBands(const LowBands&) = delete;
  LowBands& operator=(const LowBands&) = delete;
  LowBands(LowBands&&) = delete;
  LowBands& operator=(LowBands&&) = delete;

  /// Takes the strain for what follows.
  void transform(const Field& strain);
  /// Adds its displacement of the surface [m] over the grid, [i][j].
  void add_displacement(Axis axis, double* out) const;
  /// Of the strain that was taken, or of none, and of tractions on the grid. What was taken is then
  /// used up.
  void find_stress(bool strained, const Tractions& tractions, double shear_sign);
  /// What was found, in the zones: [component][cell].
  const Field& stress() const { return stress_; }

 private:
  struct Lattice;

  /// Of the lattices' planes, which ones zones read.
  void find_rows();
  void spread_layer(int k, const Field& strain);
  /// Adds what sheets of far and middle nodes give to the cells of a box, one layer.
  void gather(const double* far, const double* middle, const Box& box, double* cells) const;

  std::shared_ptr<const ZoneTables> tables_;
  const Grid& grid_;
  const std::vector<Box>& zones_;
  std::vector<std::size_t> first_;  // cells before each zone's
  std::size_t cells_ = 0;
  int layers_ = 0;
  Tensor tensor_;
  std::unique_ptr<Lattice> middle_, far_;
  Field far_strain_;  // [component][k][node] of the far lattice
  Field far_stress_;  // [k][component][node]
  Field stress_;
};

/// Numbers that are 0, of one thread: what it has once taken stays with it.
double* of_zeros(std::size_t count);

}  // namespace samcontact::operators
