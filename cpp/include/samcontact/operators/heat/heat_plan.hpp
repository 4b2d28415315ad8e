// SPDX-License-Identifier: GPL-3.0-or-later
// Data shared by all copies of a heat history: modes, near fields and tables.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/operators/heat/heat_history.hpp"
#include "samcontact/operators/heat/heat_modes.hpp"
#include "samcontact/operators/heat/heat_near.hpp"

namespace samcontact::operators {

struct HeatPlan {
  HeatPlan(const Grid& grid_, const Thermal& thermal_, const Elastic& elastic_, double vx,
           double vy, const HeatHistorySettings& settings_)
      : grid(grid_),
        thermal(thermal_),
        elastic(elastic_),
        speed_x(vx),
        speed_y(vy),
        settings(settings_),
        modes(grid, vx * grid.dx / thermal.diffusivity, vy * grid.dx / thermal.diffusivity,
              {aged(settings.shortest), aged(settings.longest), settings.tolerance,
               settings.in_depth, settings.track / grid.dx}),
        near(modes) {}

  Grid grid;
  Thermal thermal;
  Elastic elastic;
  double speed_x, speed_y;
  HeatHistorySettings settings;
  HeatModes modes;
  NearHeat near;

  /// Unit of the dimensionless amplitudes of the modes.
  double scale(HeatQuantity quantity) const {
    const double nu = elastic.nu, k = thermal.conductivity, alpha = thermal.expansion;
    switch (quantity) {
      case HeatQuantity::temperature:
        return grid.dx / k;
      case HeatQuantity::displacement:
        return -2 * alpha * (1 + nu) / k * grid.dx * grid.dx;
      default:
        return elastic.E * alpha / (1 - nu) / k * grid.dx;
    }
  }
  /// u_z of a laterally held half-space that is heated uniformly, over the limit of long waves.
  double mean_share() const { return modes.periods().is_double() ? 0.5 / (1 - elastic.nu) : 1.0; }
  double aged(double time) const { return thermal.diffusivity * time / (grid.dx * grid.dx); }

  /// Tables at a depth (in units of dx), cached: a simulation uses the same depths in every step.
  std::shared_ptr<const NearTables> tables(HeatQuantity quantity, double z) const {
    const std::lock_guard lock(mutex);
    const std::pair key(static_cast<int>(quantity), z);
    if (const auto found = kept.find(key); found != kept.end()) return found->second;
    constexpr std::size_t max_tables = 128;
    if (kept.size() >= max_tables) kept.clear();
    auto made = std::make_shared<const NearTables>(
        quantity == HeatQuantity::temperature    ? near.temperature(z)
        : quantity == HeatQuantity::displacement ? near.displacement()
                                                 : near.stress(z, elastic.nu));
    return kept[key] = std::move(made);
  }

 private:
  mutable std::mutex mutex;
  mutable std::map<std::pair<int, double>, std::shared_ptr<const NearTables>> kept;
};

}  // namespace samcontact::operators
