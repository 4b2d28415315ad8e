// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/surface_fields.hpp"

#include <cmath>

#include "samcontact/operators/surface/surface_displacement.hpp"
#include "samcontact/simulation/state/flow_zones.hpp"
#include "samcontact/simulation/strain/acting_strain.hpp"

namespace samcontact::simulation {
namespace {

/// Surface displacement due to plastic strain over cells of the body.
Field plastic_displacement(const State& state, int body, operators::Axis axis, const Box& region) {
  const Box surface{region.i0, region.j0, region.nx, region.ny, 1};
  Field out(surface.surface_size(), 0.0);
  if (!state.plastic[body]) return out;
  const Grid& grid = state.setup().grid;
  fft::Symmetry symmetry = state.plastic[body]->symmetry();
  const Box own = whole_box(state.plastic[body]->box(), grid, symmetry);
  // The operators of the box exist already.
  const bool inside = !is_elsewhere(state, body) && own.contains(surface);
  const Box around = inside ? own
                            : acting_box(*unfolded(state.plastic[body], grid, fft::Symmetry::none),
                                         surface, state.setup().reach);
  if (whole_box(part_of(around, grid, symmetry), grid, symmetry) != around) {
    symmetry = fft::Symmetry::none;
  }
  const auto history = unfolded(state.plastic[body], grid, symmetry);
  const Box stored = part_of(around, grid, symmetry);
  const auto operators =
      state.setup().cache.volume(body, around, history->tensor(), state.method, symmetry,
                                 inside ? state.heating[body] : operators::Heating{});
  operators::VolumeSpectrum spectrum = operators->make_spectrum();
  operators::forward(operators->transform(), history->strain(stored).data(), spectrum);
  Field displacement(stored.surface_size()), plane(around.surface_size());
  operators->residual_displacement(axis).apply(spectrum, displacement.data());
  unfold(displacement.data(), stored, symmetry, axis == operators::Axis::x,
         axis == operators::Axis::y, plane.data(), around, grid);
  Box layer = around;
  layer.nz = 1;
  extract(plane.data(), layer, out.data(), surface);
  return out;
}

/// Surface displacement due to plastic strain on the grid.
Field plastic_displacement(const State& state, int body, operators::Axis axis) {
  const Grid& grid = state.setup().grid;
  const double offset = state.placement().offset[body];
  if (is_in_zones(state, body)) {
    const PlasticState& history = *state.plastic[body];
    const auto tables = state.setup().cache.zone_tables(body, history.tensor(), {});
    const Zones all =
        acting_zones(history, Zones(state.flow_boxes[body]), *tables, state.setup().reach);
    operators::ZoneOperators zones(tables, all.boxes());
    zones.transform(history.strain(all), {&axis, 1});
    Field own(grid.surface_size());
    zones.displacement(axis, own.data());
    // Zones have no displacement beyond the grid.
    return seen_from_body(own, grid, -offset, Beyond::as_last);
  }
  const int more = rows_beyond(grid, offset);
  Grid wide = grid;
  wide.nx += 2 * more;
  const Box rows{-more, 0, wide.nx, grid.ny, 0};
  const Field seen = seen_from_body(plastic_displacement(state, body, axis, rows), wide, -offset);
  const std::ptrdiff_t beyond = static_cast<std::ptrdiff_t>(more) * grid.ny;
  return {seen.begin() + beyond, seen.end() - beyond};
}

void add(Field& sum, const Field& part) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
}

/// Displacement of a viscoelastic body that remains at first after unloading and then recovers.
Field recovering_displacement(const State& state, int body, operators::Axis axis,
                              const Box& region) {
  const Grid& grid = state.setup().grid;
  const TrackTractions delayed = state.delayed()[body];
  Box whole = Box::surface(grid), surface = region;
  surface.nz = 1;
  Field u;
  if (whole.contains(surface)) {
    u = displacement(delayed, RelaxingBody(state.setup(), body), {&axis, 1});
  } else {
    whole = delayed.box.united(surface);
    Grid wide = grid;
    wide.nx = whole.nx;
    wide.ny = whole.ny;
    u = operators::surface_displacement(wide, *state.setup().media[body], {}, delayed.of_box(whole),
                                        operators::shear_sign(body), axis);
  }
  Field out(surface.surface_size());
  extract(u.data(), whole, out.data(), surface);
  return out;
}

}  // namespace

Field gap(const State& state) {
  if (!state.contact_gap.empty()) return state.contact_gap;
  Field gap(state.setup().grid.surface_size(), 0.0);
  state.sources().separate(gap);
  if (std::isfinite(state.approach)) {
    const contact::Lowering lowering(state.setup().grid, state.rigid_motion());
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] -= lowering(i);
  }
  for (int body = 0; body < 2; ++body) {
    const Field u = surface_displacement(state, body);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += u[i];
  }
  return gap;
}

Field residual_displacement(const State& state, int body, operators::Axis axis, const Box& region) {
  Field out = plastic_displacement(state, body, axis, region);
  if (const auto& strain = state.eigenstrain[body]) {
    add(out, displacement_of(*strain, state.setup(), body, state.method, axis, region));
  }
  if (state.memory[body]) add(out, recovering_displacement(state, body, axis, region));
  return out;
}

Field residual_displacement(const State& state, int body, operators::Axis axis) {
  Field out = plastic_displacement(state, body, axis);
  if (const auto& strain = state.eigenstrain[body]) {
    const double offset = state.placement().offset[body];
    add(out, displacement_of(*strain, state.setup(), body, state.method, axis, offset));
  }
  if (state.memory[body]) {
    add(out, recovering_displacement(state, body, axis, Box::surface(state.setup().grid)));
  }
  return out;
}

Field surface_displacement(const State& state, int body) {
  Field out = plastic_displacement(state, body, operators::Axis::z);
  if (state.setup().media[body]->is_rigid()) return out;
  const Field of_tractions = operators::surface_displacement(
      state.setup().grid, *state.setup().media[body], state.heating[body], state.tractions,
      operators::shear_sign(body), operators::Axis::z);
  add(out, of_tractions);
  state.sources().displace(body, out);
  return out;
}

}  // namespace samcontact::simulation
