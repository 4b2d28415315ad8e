// SPDX-License-Identifier: GPL-3.0-or-later
// Data shared by all copies of a heat history: modes, near fields and tables.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "samcontact/base/grid.hpp"
#include "samcontact/base/thermal_stack.hpp"
#include "samcontact/operators/heat/half_space_response.hpp"
#include "samcontact/operators/heat/heat_history.hpp"
#include "samcontact/operators/heat/heat_modes.hpp"
#include "samcontact/operators/heat/heat_near.hpp"
#include "samcontact/operators/heat/heat_response.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/operators/heat/layered_response.hpp"

namespace samcontact::operators {

struct HeatPlan {
  HeatPlan(const Grid& grid_, const Stack& elastic_, const Heating& heating_,
           const HeatHistorySettings& settings_)
      : grid(grid_),
        elastic(elastic_),
        heating(of_unit_flux(heating_)),
        settings(settings_),
        stack(HeatedStack::of(elastic_, heating_.thermal)),
        diffusivity(std::ranges::min(stack.thermal, {}, &Thermal::diffusivity).diffusivity),
        modes(grid, heating.speed_x * grid.dx / diffusivity,
              heating.speed_y * grid.dx / diffusivity, resolution()),
        near(modes),
        response(stack.is_uniform() ? half_space_response(modes, grid.dx, stack.thermal[0],
                                                          stack.elastic.substrate)
                                    : layered_response(modes, grid.dx, diffusivity, stack)) {}

  Grid grid;
  Stack elastic;
  Heating heating;  // of a unit flux
  HeatHistorySettings settings;
  HeatedStack stack;
  double diffusivity;  // smallest of the layers [m^2/s]
  HeatModes modes;
  NearHeat near;
  std::unique_ptr<const HeatResponse> response;

  double aged(double time) const { return diffusivity * time / (grid.dx * grid.dx); }

  /// Tables at a depth (in units of dx), cached: a simulation uses the same depths in every step.
  std::shared_ptr<const NearTables> tables(HeatQuantity quantity, double z) const {
    const std::lock_guard lock(mutex_);
    const std::pair key(static_cast<int>(quantity), z);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    constexpr std::size_t max_tables = 128;
    if (kept_.size() >= max_tables) kept_.clear();
    auto made = std::make_shared<const NearTables>(
        quantity == HeatQuantity::temperature    ? near.temperature(z)
        : quantity == HeatQuantity::displacement ? near.displacement()
                                                 : near.stress(z, stack.elastic.substrate.nu));
    return kept_[key] = std::move(made);
  }

 private:
  static Heating of_unit_flux(Heating heating) {
    heating.factor = 1.0;
    heating.of_slip = false;
    return heating;
  }
  HeatResolution resolution() const {
    HeatResolution resolution{aged(settings.shortest),
                              aged(settings.longest),
                              settings.tolerance,
                              settings.in_depth,
                              {settings.track[0] / grid.dx, settings.track[1] / grid.dx}};
    if (stack.is_uniform()) return resolution;
    resolution.layers = longest_heat_length(stack) / grid.dx;
    const auto most = std::ranges::max(stack.thermal, {}, &Thermal::diffusivity);
    resolution.contrast = most.diffusivity / diffusivity;
    return resolution;
  }

  mutable std::mutex mutex_;
  mutable std::map<std::pair<int, double>, std::shared_ptr<const NearTables>> kept_;
};

}  // namespace samcontact::operators
