// SPDX-License-Identifier: GPL-3.0-or-later
// Search for cells whose elastic stress under given tractions comes close to the yield stress,
// without volume fields: with increasing depth the stress becomes smoother and the search grid
// coarser.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/operators/volume/traction_stress.hpp"
#include "samcontact/operators/zones/stress_bound.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"
#include "samcontact/simulation/scene/strength.hpp"

namespace samcontact::simulation {

/// Limit of the stress: a fraction of the softened yield strength; a different fraction for layers
/// weaker than those above.
struct YieldLimit {
  const Strength& strength;
  double softening, share, weak_share;
  operators::DeviatorAt past{};  // stress in addition to that due to tractions; empty: 0

  std::vector<LayerLimit> of(const std::vector<LayerRange>& ranges) const {
    return strength.limits(ranges, softening, share, weak_share);
  }
};

class YieldScan {
 public:
  /// heat: heat proportional to the pressure; null: no heat.
  YieldScan(const Grid& grid, const Strength& strength, const operators::SharedMedium& medium,
            const std::shared_ptr<const operators::HeatStress>& heat);

  /// Box of all cells whose von Mises stress under the tractions exceeds the limit; empty if there
  /// are none. Tractions in the frame of the body except for the sign of the shear. Covers the
  /// layers of the grid; if their number is not limited, down to a depth of one grid width, or as
  /// far as the strength changes.
  Box box(const operators::Tractions& tractions, double shear_sign, const YieldLimit& limit) const {
    return box(levels_, tractions, shear_sign, limit);
  }
  /// Box of the cells in the layers below those of the grid.
  Box box_below(const operators::Tractions& tractions, double shear_sign,
                const YieldLimit& limit) const {
    return box(below_, tractions, shear_sign, limit);
  }
  /// Whether a surface that is periodic in both directions exceeds the limit at any depth.
  bool is_beyond_everywhere(const operators::Tractions& tractions, double shear_sign,
                            const YieldLimit& limit) const;
  /// Depth to which each column of the grid exceeds the limit, at any depth.
  Columns columns(const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit) const;

  std::size_t bytes() const;

 private:
  /// Surface grid, coarser than that of the simulation by a factor, and the depths for which it is
  /// used.
  struct Level {
    int factor;
    Grid grid;
    std::vector<LayerRange> ranges;  // of the simulation grid
    operators::VolumeTransform transform;
    operators::TractionStress stress;

    Level(const Grid& fine, int factor_, std::vector<LayerRange> ranges_,
          const operators::SharedMedium& medium,
          const std::shared_ptr<const operators::HeatStress>& heat);
  };
  /// Calls use(cells of the grid) for each cell of a level beyond the limit; the layers extend to
  /// the next depth that is searched.
  template <class Use>
  void for_beyond(const Level& level, const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit, const Use& use) const;
  using Levels = std::vector<std::unique_ptr<Level>>;
  Box box(const Levels& levels, const operators::Tractions& tractions, double shear_sign,
          const YieldLimit& limit) const;
  Box level_box(const Level& level, const operators::Tractions& tractions, double shear_sign,
                const YieldLimit& limit) const;

  Grid grid_;
  Levels levels_, below_;  // for the layers of the grid, and for those below
};

/// Yield scans by body; null for an elastic body.
using Scans = std::array<std::shared_ptr<const YieldScan>, 2>;

/// Search by columns, from an upper bound of the stress, at a cost that is acceptable for large
/// surfaces; without heat.
class ZoneScan {
 public:
  ZoneScan(const std::shared_ptr<const operators::ZoneTables>& tables, const Strength& strength);

  /// Columns of the grid, down to below the deepest cell whose stress may exceed the limit.
  Columns columns(const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit) const;
  /// Whether the searched depths resolve this strength.
  bool resolves(const Strength& strength) const;

  const std::shared_ptr<const operators::ZoneTables>& tables() const { return tables_; }
  std::size_t bytes() const { return bound_.bytes(); }

 private:
  std::shared_ptr<const operators::ZoneTables> tables_;
  Grid grid_;
  std::vector<LayerRange> ranges_;  // that are searched
  operators::StressBound bound_;
};

}  // namespace samcontact::simulation
