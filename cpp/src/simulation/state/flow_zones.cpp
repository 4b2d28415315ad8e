// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/flow_zones.hpp"

namespace samcontact::simulation {

bool is_in_zones(const State& state, int body) {
  const auto& history = state.plastic[body];
  return history && state.flow_boxes[body].size() > 1 &&
         history->symmetry() == fft::Symmetry::none &&
         state.method == operators::ResidualMethod::fast && state.setup().may_split() &&
         (!state.setup().grid.period.is_on() || state.travel == Travel{});
}

bool has_zone_stress(const State& state, int body) {
  return is_in_zones(state, body) && state.travel == Travel{} &&
         !state.plastic[body]->reaches_beyond(Zones(state.flow_boxes[body]));
}

bool is_elsewhere(const State& state, int body) {
  const auto& history = state.plastic[body];
  if (!history) return false;
  const Box whole = whole_box(history->box(), state.setup().grid, history->symmetry());
  return state.flow_boxes[body] != std::vector{whole};
}

std::vector<Box> zones(const State& state, int body) {
  if (!state.plastic[body]) return {};
  if (has_zone_stress(state, body)) return state.flow_boxes[body];
  const PlasticState& history = *state.plastic[body];
  const Box strained = whole_box(history.zones().around(), state.setup().grid, history.symmetry())
                           .intersected(state.below({}));
  return strained.empty() ? std::vector<Box>{} : std::vector{strained};
}

}  // namespace samcontact::simulation
