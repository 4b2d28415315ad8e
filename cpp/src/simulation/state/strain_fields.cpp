// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/strain_fields.hpp"

#include "samcontact/simulation/cells/tensor_fields.hpp"

#include <algorithm>
#include <cmath>

namespace samcontact::simulation {
namespace {

/// Calls use(index, mixed cell) for all cells of zones that inclusions fill, completely or partly.
template <class Use>
void for_mixed_cells(const State& state, int body, const Zones& zones, const Use& use) {
  const auto& inclusions = state.setup().inclusions[body];
  if (!inclusions) return;
  const int first = state.placement().first[body];
  for (std::size_t n = 0; n < zones.cells(); ++n) {
    const auto [i, j, k] = zones.cell(n);
    const auto* mixed = inclusions->at(i, j, k, first, state.setup().grid.period);
    if (mixed != nullptr) use(n, *mixed);
  }
}

/// Largest sqrt(2/3 e:e) of a strain [6][cell].
double largest_magnitude(const Field& strain) {
  const std::size_t cells = strain.size() / 6;
  double largest = 0.0;
  for (std::size_t n = 0; n < cells; ++n) {
    double square = 0.0;
    for (std::size_t c = 0; c < 6; ++c) {
      const double e = strain[c * cells + n];
      square += (c < 3 ? 1.0 : 2.0) * e * e;
    }
    largest = std::max(largest, square);
  }
  return std::sqrt(2.0 / 3 * largest);
}

/// Plastic strain in zones of the stored part of a history, six components. share_of: weight of
/// the inclusion in a cell of two phases.
template <class ShareOf>
Field plastic_strain_of(const State& state, int body, const PlasticState& history,
                        const Zones& zones, const ShareOf& share_of) {
  Field strain = six_components(history.strain(zones), history.tensor());
  const std::size_t cells = zones.cells();
  const auto field = [&](const std::shared_ptr<const PlasticState>& flow) {
    const auto own = unfolded(flow, state.setup().grid, history.symmetry());
    return own ? six_components(own->strain(zones), own->tensor()) : Field(6 * cells, 0.0);
  };
  const Field flow = field(state.inclusions_flow[body]), rest = field(state.matrix_flow[body]);
  for_mixed_cells(state, body, zones, [&](std::size_t n, const plasticity::MixedCell& mixed) {
    const double share = mixed.has_two_phases() ? share_of(mixed) : 1.0;
    for (std::size_t at = n; at < 6 * cells; at += cells) {
      strain[at] = share * flow[at] + (1 - share) * rest[at];
    }
  });
  return strain;
}

double mean_share(const plasticity::MixedCell& mixed) { return mixed.share; }

/// Plastic strain over a region.
template <class ShareOf>
Field plastic_strain_in(const State& state, int body, const Box& region, const ShareOf& share_of) {
  state.setup().require_volume(body);
  if (!state.plastic[body]) return Field(6 * region.volume_size(), 0.0);
  const auto history = unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none);
  return plastic_strain_of(state, body, *history, Zones({region}), share_of);
}

}  // namespace

Field plastic_strain(const State& state, int body, Layers layers) {
  return plastic_strain(state, body, state.below(layers));
}

Field plastic_strain(const State& state, int body, const Box& region) {
  return plastic_strain_in(state, body, region, mean_share);
}

Field matrix_plastic_strain(const State& state, int body, Layers layers) {
  return plastic_strain_in(state, body, state.below(layers), [](const auto&) { return 0.0; });
}

Field inclusion_plastic_strain(const State& state, int body, Layers layers) {
  return plastic_strain_in(state, body, state.below(layers), [](const auto&) { return 1.0; });
}

Field inclusion_equivalent_strain(const State& state, int body, Layers layers) {
  const Box region = state.below(layers);
  Field equivalent = equivalent_plastic_strain(state, body, region);
  const auto own = unfolded(state.matrix_flow[body], state.setup().grid, fft::Symmetry::none);
  const Field known = own ? own->equivalent(region) : Field(equivalent.size(), 0.0);
  for_mixed_cells(state, body, Zones({region}), [&](std::size_t n, const auto& mixed) {
    if (mixed.has_two_phases()) equivalent[n] = known[n];
  });
  return equivalent;
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
  Field sum = strain ? strain->strain(region) : Field(6 * region.volume_size(), 0.0);
  if (!state.setup().inclusions[body] || !state.plastic[body]) return sum;
  const auto history = unfolded(state.plastic[body], state.setup().grid, fft::Symmetry::none);
  const Field own = six_components(history->strain(region), history->tensor());
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += own[n];
  return sum;
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
  if (!state.travel.is_along_x()) {
    seen.j0 = whole.j0;
    seen.ny = whole.ny;
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
  if (!state.plastic[body]) return 0.0;
  const PlasticState& history = *state.plastic[body];
  if (!state.setup().inclusions[body]) return history.tiles().max_equivalent();
  const Zones zones = history.zones();
  Field equivalent = history.equivalent(zones);
  for_mixed_cells(state, body, zones, [&](std::size_t n, const plasticity::MixedCell& mixed) {
    if (mixed.share < 1) equivalent[n] = 0.0;
  });
  return equivalent.empty() ? 0.0 : *std::max_element(equivalent.begin(), equivalent.end());
}

double max_plastic_strain_magnitude(const State& state, int body) {
  if (!state.plastic[body]) return 0.0;
  const PlasticState& history = *state.plastic[body];
  if (!state.setup().inclusions[body]) return history.tiles().max_strain();
  const Zones zones = history.zones();
  return largest_magnitude(plastic_strain_of(state, body, history, zones, mean_share));
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
