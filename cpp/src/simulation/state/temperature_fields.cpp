// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/temperature_fields.hpp"

#include <array>

#include "samcontact/operators/heat/temperature.hpp"

namespace samcontact::simulation {
Field temperature(const State& state, int body, Layers layers) {
  state.setup().require_volume(body);
  const Field pressure = state.tractions_on(body).pressure;
  const Box region = state.below(layers);
  const auto depths = state.setup().grid.z(region.nz);
  Field rise =
      state.setup().cache.temperature(state.heating[body], region)->rise(pressure.data(), depths);
  const GivenHeat heat = state.given_heat()[body];
  if (heat.is_on()) add(heat.temperature(depths, state.placement().offset[body]), rise);
  return rise;
}

Field surface_temperature(const State& state, int body) {
  const std::array surface{0.0};
  Field rise = operators::Temperature(state.setup().grid, state.heating[body])
                   .rise(state.tractions.pressure.data(), surface);
  if (const GivenHeat heat = state.given_heat()[body]; heat.is_on()) {
    add(heat.temperature(surface, state.placement().offset[body]), rise);
  }
  return rise;
}

}  // namespace samcontact::simulation
