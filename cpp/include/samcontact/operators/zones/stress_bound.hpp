// SPDX-License-Identifier: GPL-3.0-or-later
// Upper bound of the von Mises stress due to tractions, cell by cell: the stress of the smooth
// bands plus the sum of the absolute near-band contributions of each surface cell.
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

  /// Size along x and y of a block of cells with a common bound [cells]; the first cells of the
  /// grid form its first block.
  int block() const { return tables_->split().middle_spacing; }
  int blocks_x() const;
  int blocks_y() const;

  /// Stress in addition to that due to tractions.
  struct Given {
    std::vector<std::array<double, 3>> start;  // a deviator at each depth: xx, yy and xy [Pa]
    DeviatorAt more{};                         // smooth; empty: 0
  };
  /// Calls use(index of the depth, bound [i][j] of blocks [Pa]), in any order and from several
  /// threads. shear_sign: factor of the shear on the body.
  using Use = std::function<void(int depth, const double* bound)>;
  void for_each_depth(const Tractions& tractions, double shear_sign, const Given& given,
                      const Use& use) const;

  std::size_t bytes() const;

 private:
  /// Group of depths that are evaluated together.
  struct Group;
  /// Tractions on the cells and on the nodes of both lattices.
  struct Loads;

  void evaluate(const Group& group, const Loads& loads, double shear_sign, const Given& given,
                const Use& use) const;
  /// Von Mises stress of the smooth bands at the corners of blocks, from nodes [component][a][b],
  /// plus optionally a deviator of cells [i][j], whose components are `step` apart.
  Field at_corners(const Field& nodes, const std::array<double, 3>& start, const double* more,
                   std::size_t step) const;
  Field near_part(double depth, const Tractions& tractions) const;

  std::shared_ptr<const ZoneTables> tables_;
  NodePlanes middle_, far_;
  VolumeTransform middle_transform_, far_transform_;
  std::vector<std::unique_ptr<const Group>> groups_;
};

}  // namespace samcontact::operators
