// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/stress_fields.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/simulation/cells/tensor_fields.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/state/flow_zones.hpp"
#include "samcontact/simulation/strain/acting_strain.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Mirror planes of the stress of a history; the exact operators support none.
fft::Symmetry stress_symmetry(const State& state, int body, bool with_tractions) {
  if (state.method == operators::ResidualMethod::exact) return fft::Symmetry::none;
  const fft::Symmetry of_strain = state.plastic[body]->symmetry();
  if (!with_tractions) return of_strain;
  const fft::Symmetry of_heat = common(state.past_symmetry, symmetry_of(state.heating));
  return common(common(of_strain, of_heat), symmetry_of(state.tractions, state.setup().grid));
}

Field stress_of_strain(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  if (!state.plastic[body]) return Field(6 * region.volume_size(), 0.0);
  return stress_of(*state.plastic[body], state.setup(), body, state.method, region);
}

/// region: the whole grid.
Field total_stress(const State& state, int body, bool with_tractions, const Box& region) {
  const Grid& grid = state.setup().grid;
  state.setup().require_volume(body);
  const double sign = operators::shear_sign(body);
  if (!state.plastic[body] && !with_tractions) return Field(6 * region.volume_size(), 0.0);
  const operators::Heating heat = with_tractions ? state.heating[body] : operators::Heating{};
  const operators::Tractions loads = state.tractions_on(body);
  const auto of_tractions = [&] {
    return state.setup()
        .cache.volume(body, region, Tensor::full, state.method, fft::Symmetry::none, heat)
        ->stress(nullptr, &loads, sign);
  };
  if (is_elsewhere(state, body)) {
    Field out = stress_of_strain(state, body, region);
    if (with_tractions) add(of_tractions(), out);
    return out;
  }
  if (!state.plastic[body]) return of_tractions();

  const fft::Symmetry symmetry = stress_symmetry(state, body, with_tractions);
  const auto history = unfolded(state.plastic[body], grid, symmetry);
  const Box box = whole_box(history->box(), grid, symmetry), around = region.united(box);
  Field out(6 * region.volume_size());
  const auto put = [&](const Box& whole) {
    const Box stored = part_of(whole, grid, symmetry);
    const operators::Tractions here = window(loads, grid, stored);
    const Field strain = six_components(history->strain(stored), history->tensor());
    const Field part = state.setup()
                           .cache.volume(body, whole, Tensor::full, state.method, symmetry, heat)
                           ->stress(strain.data(), with_tractions ? &here : nullptr, sign);
    put_unfolded(part, stored, symmetry, grid, region, out);
  };
  // In the box, exactly the stress from which the plastic flow was computed: the fast operator
  // depends slightly on the period.
  const bool exact = state.method == operators::ResidualMethod::exact;
  if (exact || box != around) put(around);
  if (!exact) put(box);
  return out;
}

}  // namespace

Field stress(const State& state, int body, Layers layers) {
  const Box region = state.below(layers);
  Field stress = total_stress(state, body, true, region);
  state.sources().stress(body, region, Tensor::full, stress);
  return stress;
}

Field residual_stress(const State& state, int body, Layers layers) {
  const Box region = state.below(layers);
  Field stress = total_stress(state, body, false, region);
  state.sources().residual_stress(body, region, Tensor::full, stress);
  return stress;
}

Field disturbance(const State& state, int body, Layers layers) {
  return total_stress(state, body, false, state.below(layers));
}

Field residual_stress(const State& state, int body, const Box& region) {
  Field stress = stress_of_strain(state, body, region);
  state.sources().residual_stress(body, region, Tensor::full, stress);
  return stress;
}

Field initial_stress(const State& state, int body, Layers layers) {
  return initial_stress(state, body, state.below(layers));
}

Field initial_stress(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  Field stress(6 * region.volume_size(), 0.0);
  state.setup().strength(body, state.travel).add_stress(region, Tensor::full, stress);
  return stress;
}

Field eigenstress(const State& state, int body, Layers layers) {
  return eigenstress(state, body, state.below(layers));
}

Field eigenstress(const State& state, int body, const Box& region) {
  state.setup().require_volume(body);
  const auto& strain = state.eigenstrain[body];
  if (!strain) return Field(6 * region.volume_size(), 0.0);
  return stress_of(*strain, state.setup(), body, state.method, region);
}

Field stress_in_zones(const State& state, int body, bool with_tractions) {
  const std::vector<Box> boxes = zones(state, body);
  if (boxes.empty()) return {};
  if (!has_zone_stress(state, body)) {
    return cut(with_tractions ? stress(state, body) : residual_stress(state, body), state.below({}),
               boxes.front());
  }
  const operators::Heating heat = with_tractions ? state.heating[body] : operators::Heating{};
  const auto tables = state.setup().cache.zone_tables(body, Tensor::full, heat);
  const Zones zones(boxes);
  operators::ZoneOperators operators(tables, boxes);
  const Field strain =
      six_components(state.plastic[body]->strain(zones), state.plastic[body]->tensor());
  operators.transform(strain);
  Field out(6 * zones.cells());
  operators.for_each_layer(
      &strain, with_tractions ? state.tractions : operators::Tractions{},
      operators::shear_sign(body), [&](std::size_t zone, int k, const double* stress) {
        const Box& box = zones.boxes()[zone];
        const std::size_t plane = box.surface_size();
        double* first = out.data() + 6 * zones.first(zone) + k * plane;
        for (int c = 0; c < 6; ++c) {
          std::copy_n(stress + c * plane, plane, first + c * box.volume_size());
        }
      });
  tables->forget_unused();
  const Sources sources = state.sources();
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    const Box& box = zones.boxes()[zone];
    Field start;
    if (with_tractions) {
      sources.stress(body, box, Tensor::full, start);
    } else {
      sources.residual_stress(body, box, Tensor::full, start);
    }
    double* to = out.data() + 6 * zones.first(zone);
    for (std::size_t n = 0; n < start.size(); ++n) to[n] += start[n];
  }
  return out;
}

Box own_box(const State& state, int body) {
  if (!state.plastic[body] || is_elsewhere(state, body) || !state.sources().all_remain(body))
    return {};
  const Grid& grid = state.setup().grid;
  Box box = whole_box(state.plastic[body]->box(), grid, state.plastic[body]->symmetry());
  Box window = window_of(state.tractions_on(body), grid);
  window.nz = box.nz;
  if (!box.contains(window)) return {};
  if (grid.nz > 0) box.nz = std::min(box.nz, grid.nz);
  return box;
}

Field deviator_in_own_box(const State& state, int body, bool with_tractions) {
  const Box region = own_box(state, body);
  if (region.empty()) return {};
  const Grid& grid = state.setup().grid;
  const fft::Symmetry symmetry = stress_symmetry(state, body, with_tractions);
  const auto history = unfolded(state.plastic[body], grid, symmetry);
  const Box& stored = history->box();
  const operators::Tractions here = window(state.tractions_on(body), grid, stored);
  const Field part = state.setup()
                         .cache
                         .volume(body, whole_box(stored, grid, symmetry), history->tensor(),
                                 state.method, symmetry, state.heating[body])
                         ->stress(history->strain(stored).data(), with_tractions ? &here : nullptr,
                                  operators::shear_sign(body));
  Field out(6 * region.volume_size());
  put_unfolded(six_components(part, history->tensor()), stored, symmetry, grid, region, out);
  Field start;
  state.sources().stress(body, region, Tensor::deviator, start);
  if (start.empty()) return out;
  start = six_components(std::move(start), Tensor::deviator);
  for (std::size_t n = 0; n < out.size(); ++n) out[n] += start[n];
  return out;
}

}  // namespace samcontact::simulation
