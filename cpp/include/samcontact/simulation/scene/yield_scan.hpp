// SPDX-License-Identifier: GPL-3.0-or-later
// Where the elastic stress under given tractions comes near the yield stress, without a volume:
// the deeper, the smoother the stress, and the coarser the grid that finds it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/operators/volume/traction_stress.hpp"
#include "samcontact/operators/zones/stress_bound.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"
#include "samcontact/simulation/scene/strength.hpp"

namespace samcontact::simulation {

/// What to compare stress with: a share of what a body bears, softened by a factor; of layers that
/// are weaker than others above another one.
struct YieldLimit {
  const Strength& strength;
  double softening, share, share_of_weak;
  operators::DeviatorAt past{};  // stress that is there besides that of tractions; none: 0

  std::vector<LayerLimit> of(const std::vector<LayerRange>& ranges) const {
    return strength.limits(ranges, softening, share, share_of_weak);
  }
};

class YieldScan {
 public:
  /// heat: that goes with the pressure; null: none.
  YieldScan(const Grid& grid, const Strength& strength, const operators::SharedMedium& medium,
            const std::shared_ptr<const operators::HeatStress>& heat);

  /// The box of all cells whose von Mises stress under the tractions exceeds the limit; empty when
  /// there is none. Tractions in the body's own frame but for the sign of the shear. In the layers
  /// of the grid; without a bottom, as deep as its window is wide and as the strength changes.
  Box box(const operators::Tractions& tractions, double shear_sign, const YieldLimit& limit) const {
    return box(levels_, tractions, shear_sign, limit);
  }
  /// The same of layers below those of the grid.
  Box box_below(const operators::Tractions& tractions, double shear_sign,
                const YieldLimit& limit) const {
    return box(below_, tractions, shear_sign, limit);
  }
  /// Whether a surface that is periodic in both directions exceeds it at any depth.
  bool is_beyond_everywhere(const operators::Tractions& tractions, double shear_sign,
                            const YieldLimit& limit) const;
  /// By column of the grid, down to any depth.
  Columns columns(const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit) const;

  std::size_t bytes() const;

 private:
  /// One grid of the surface, coarser than the scene's by a factor, and the depths it serves.
  struct Level {
    int factor;
    Grid grid;
    std::vector<LayerRange> ranges;  // of the scene's grid
    operators::VolumeTransform transform;
    operators::TractionStress stress;

    Level(const Grid& fine, int factor_, std::vector<LayerRange> ranges_,
          const operators::SharedMedium& medium,
          const std::shared_ptr<const operators::HeatStress>& heat);
  };
  /// Calls use(cells of the grid) for each cell of a level beyond the limit; their layers are down
  /// to the next depth that is looked at.
  template <class Use>
  void for_beyond(const Level& level, const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit, const Use& use) const;
  using Levels = std::vector<std::unique_ptr<Level>>;
  Box box(const Levels& levels, const operators::Tractions& tractions, double shear_sign,
          const YieldLimit& limit) const;
  Box level_box(const Level& level, const operators::Tractions& tractions, double shear_sign,
                const YieldLimit& limit) const;

  Grid grid_;
  Levels levels_, below_;  // of the grid's layers, and below them
};

/// By body; null where nothing can yield.
using Scans = std::array<std::shared_ptr<const YieldScan>, 2>;

/// The same by columns, from a bound of the stress, at a cost that large surfaces can bear; without
/// heat.
class ZoneScan {
 public:
  ZoneScan(const std::shared_ptr<const operators::ZoneTables>& tables, const Strength& strength);

  /// Columns of the grid, down to below the deepest cell whose stress may exceed the limit.
  Columns columns(const operators::Tractions& tractions, double shear_sign,
                  const YieldLimit& limit) const;
  /// Whether it looks where this strength changes.
  bool resolves(const Strength& strength) const;

  const std::shared_ptr<const operators::ZoneTables>& tables() const { return tables_; }
  std::size_t bytes() const { return bound_.bytes(); }

 private:
  std::shared_ptr<const operators::ZoneTables> tables_;
  Grid grid_;
  std::vector<LayerRange> ranges_;  // that are looked at
  operators::StressBound bound_;
};

}  // namespace samcontact::simulation
