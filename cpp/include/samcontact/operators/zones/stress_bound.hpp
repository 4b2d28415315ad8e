// SPDX-License-Identifier: GPL-3.0-or-later
// A bound of the von Mises stress of tractions, cell by cell: that of what is smooth, plus what
// lies near each cell of the surface, taken together without regard to signs.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "samcontact/operators/zones/zone_operators.hpp"

namespace samcontact::operators {

/// The deviator of a stress at some depths [m]: [component][depth][i][j] of the grid [Pa].
using DeviatorAt = std::function<Field(std::span<const double> depths)>;

class StressBound {
 public:
  /// At depths [m], ascending.
  StressBound(std::shared_ptr<const ZoneTables> tables, const std::vector<double>& depths);
  ~StressBound();

  /// Cells of a block along x and y, which one bound serves: the first cells are those of the
  /// grid's first block.
  int block() const { return tables_->split().middle_spacing; }
  int blocks_x() const;
  int blocks_y() const;

  /// What is there besides.
  struct Given {
    std::vector<std::array<double, 3>> start;  // a deviator at each depth: xx, yy and xy [Pa]
    DeviatorAt more{};                         // smooth; none: 0
  };
  /// Calls use(number of the depth, bound [i][j] of blocks [Pa]), in any order and several at once.
  /// shear_sign: as everywhere.
  using Use = std::function<void(int depth, const double* bound)>;
  void for_each_depth(const Tractions& tractions, double shear_sign, const Given& given,
                      const Use& use) const;

  std::size_t bytes() const;

 private:
  /// Some depths, one after the other.
  struct Group;
  /// Tractions on the cells and on the nodes of both lattices.
  struct Loads;

  void look_at(const Group& group, const Loads& loads, double shear_sign, const Given& given,
               const Use& use) const;
  /// Von Mises stress of what is smooth at the corners of blocks, from nodes [component][a][b], and
  /// where told a deviator of cells [i][j], its components `step` apart.
  Field at_corners(const Field& nodes, const std::array<double, 3>& start, const double* more,
                   std::size_t step) const;
  Field near_part(double depth, const Tractions& tractions) const;

  std::shared_ptr<const ZoneTables> tables_;
  NodePlanes middle_, far_;
  VolumeTransform middle_transform_, far_transform_;
  std::vector<std::unique_ptr<const Group>> groups_;
};

}  // namespace samcontact::operators
