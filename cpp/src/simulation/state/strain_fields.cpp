// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/strain_fields.hpp"

#include "samcontact/simulation/cells/tensor_fields.hpp"

namespace samcontact::simulation {

Field plastic_strain(const State& state, int body, Layers layers) {
  return plastic_strain(state, body, state.below(layers));
}

Field plastic_strain(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  if (!state.plastic[body]) return Field(6 * region.volume_size(), 0.0);
  const auto history = unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none);
  return six_components(history->strain(region), history->tensor());
}

Field equivalent_plastic_strain(const State& state, int body, Layers layers) {
  return equivalent_plastic_strain(state, body, state.below(layers));
}

Field equivalent_plastic_strain(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  if (!state.plastic[body]) return Field(region.volume_size(), 0.0);
  return unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none)->equivalent(region);
}

Field eigenstrain(const State& state, int body, Layers layers) {
  return eigenstrain(state, body, state.below(layers));
}

Field eigenstrain(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  const auto& strain = state.eigenstrain[body];
  return strain ? strain->strain(region) : Field(6 * region.volume_size(), 0.0);
}

Box strain_beyond(const State& state, int body) {
  if (!state.plastic[body]) return {};
  const Grid& grid = state.setup().grid;
  const auto history = state.plastic[body];
  const Box whole = whole_box(history->box(), grid, history->symmetry());
  Box seen{0, 0, grid.nx, grid.ny, grid.nz > 0 ? grid.nz : whole.nz};
  const Box flow = around(state.flow_boxes[body]);
  if (state.travel != Travel{} || (flow.i0 >= 0 && flow.i0 + flow.nx <= grid.nx)) {
    seen.i0 = whole.i0;
    seen.nx = whole.nx;
  }
  if (seen.contains(whole)) return {};
  const Box strained = whole_box(history->zones().around(), grid, history->symmetry());
  return seen.contains(strained) ? Box{} : strained;
}

std::size_t plastic_cells(const State& state, int body) {
  const auto whole = unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none);
  return whole ? whole->tiles().yielded_cells() : 0;
}

double max_equivalent_plastic_strain(const State& state, int body) {
  return state.plastic[body] ? state.plastic[body]->tiles().max_equivalent() : 0.0;
}

double max_plastic_strain_magnitude(const State& state, int body) {
  return state.plastic[body] ? state.plastic[body]->tiles().max_strain() : 0.0;
}

Field backstress(const State& state, int body, Layers layers) {
  return backstress(state, body, state.below(layers));
}

Field backstress(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  const std::size_t cells = region.volume_size();
  const std::size_t terms = state.setup().bodies[body].backstresses();
  Field out(6 * terms * cells, 0.0);
  if (!state.plastic[body] || terms == 0) return out;
  const Field deviators =
      unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none)->backstress(region);
  for (std::size_t n = 0; n < terms; ++n) {
    complete(deviators.data() + 5 * n * cells, cells, out.data() + 6 * n * cells);
  }
  return out;
}

Field yield_factor(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  const Field factor = state.setup().strength(body, state.travel).factor(region);
  return factor.empty() ? Field(region.volume_size(), 1.0) : factor;
}

}  // namespace samcontact::simulation
