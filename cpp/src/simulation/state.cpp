// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "samcontact/operators/heat/temperature.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"
#include "samcontact/simulation/outside_strain.hpp"
#include "samcontact/simulation/tensor_fields.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

void add(const Field& from, Field& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}

}  // namespace

operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box) {
  const Box surface = Box::surface(grid);
  Box part = box;
  part.nz = 1;
  if (part == surface) return tractions;
  operators::Tractions out;
  const auto cut = [&](const Field& from, Field& to) {
    if (from.empty()) return;
    to.assign(box.surface_size(), 0.0);
    copy_common(from.data(), surface, to.data(), part);
  };
  cut(tractions.pressure, out.pressure);
  cut(tractions.shear_x, out.shear_x);
  cut(tractions.shear_y, out.shear_y);
  return out;
}

State::State(std::shared_ptr<const Scene> scene, operators::ResidualMethod method_)
    : method(method_), scene_(std::move(scene)) {
  tractions.pressure.assign(scene_->grid.surface_size(), 0.0);
  approach = *std::min_element(scene_->initial_gap.begin(), scene_->initial_gap.end());
}

PastHeat State::heat_so_far() const {
  PastHeat so_far = past;
  if (!scene_->march.is_on() || time == 0) return so_far;
  for (int b = 0; b < 2; ++b) {
    if (b == 1 && heating[0] == heating[1] && past[0] == past[1] &&
        scene_->media[0] == scene_->media[1]) {
      so_far[1] = so_far[0];
      continue;
    }
    if (!past[b] && !heating[b].is_on()) continue;
    auto history = std::make_shared<operators::HeatHistory>(
        past[b] ? *past[b] : scene_->heat_history(b, heating[b]));
    Field flux = tractions.pressure;
    for (double& q : flux) q *= heating[b].factor;
    history->add(flux.data(), duration);
    so_far[b] = std::move(history);
  }
  return so_far;
}

fft::Symmetry State::heat_symmetry_so_far() const {
  if (!heating[0].is_on() && !heating[1].is_on()) return past_symmetry;
  const fft::Symmetry flux = symmetry_of(tractions.pressure, scene_->grid);
  return common(past_symmetry, common(flux, symmetry_of(heating)));
}

Field shear_vectors(const operators::Tractions& tractions) {
  const auto& [pressure, along_x, along_y] = tractions;
  if (along_x.empty() && along_y.empty()) return {};
  const std::size_t n = pressure.size();
  Field both(2 * n, 0.0);
  std::copy(along_x.begin(), along_x.end(), both.begin());
  std::copy(along_y.begin(), along_y.end(), both.begin() + static_cast<std::ptrdiff_t>(n));
  return both;
}

std::array<double, 3> State::tangential_force() const {
  const Field both = shear_vectors(tractions);
  return both.empty() ? std::array<double, 3>{} : contact::forces(scene_->grid, both);
}

State State::moved(const Travel& to) const {
  State state = *this;
  state.travel = to;
  state.advance = {to[0] - travel[0], to[1] - travel[1]};
  const Grid& grid = scene_->grid;
  const Placement from = placement(), place = state.placement();
  const auto cells = static_cast<int>(std::lround(place.origin - from.origin));
  state.tractions.pressure = simulation::moved(tractions.pressure, grid, cells);
  state.tractions.shear_x = simulation::moved(tractions.shear_x, grid, cells);
  state.tractions.shear_y = simulation::moved(tractions.shear_y, grid, cells);
  state.contact_gap.clear();
  for (int b = 0; b < 2; ++b) {
    if (!plastic[b]) continue;
    const int by = from.first[b] - place.first[b];
    if (b == 1 && plastic[0] == plastic[1] && by == from.first[0] - place.first[0]) {
      state.plastic[1] = state.plastic[0];
      continue;
    }
    const auto symmetry = common(plastic[b]->symmetry(), fft::Symmetry::y);
    state.plastic[b] = unfolded(plastic[b], grid, symmetry)->moved(by, 0);
  }
  return state;
}

Field State::gap() const {
  if (!contact_gap.empty()) return contact_gap;
  Field gap = scene_->gap(travel);
  const double moved = std::isfinite(approach) ? approach : 0.0;
  for (double& g : gap) g -= moved;
  for (int body = 0; body < 2; ++body) {
    const Field u = surface_displacement(body);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += u[i];
  }
  return gap;
}

operators::Tractions State::tractions_on(int body) const {
  return seen_from_body(tractions, scene_->grid, placement().offset[body]);
}

bool State::is_elsewhere(int body) const {
  const auto& history = plastic[body];
  if (!history) return false;
  const Box whole = whole_box(history->box(), scene_->grid, history->symmetry());
  return flow_boxes[body] != std::vector{whole};
}

int State::layers() const {
  Box box = scene_->volume_below(tractions.pressure);
  if (scene_->grid.nz > 0) return box.nz;
  for (const auto& history : plastic) {
    if (history) box.nz = std::max(box.nz, history->box().nz);
  }
  return box.nz;
}

Box State::below(Layers layers) const {
  const Grid& grid = scene_->grid;
  return {0, 0, grid.nx, grid.ny, layers ? *layers : this->layers()};
}

/// Mirror planes that its stress has; the exact operators know of none.
fft::Symmetry State::stress_symmetry(int body, bool with_tractions) const {
  if (method == operators::ResidualMethod::exact) return fft::Symmetry::none;
  const fft::Symmetry of_strain = plastic[body]->symmetry();
  if (!with_tractions) return of_strain;
  const fft::Symmetry of_heat = common(past_symmetry, symmetry_of(heating));
  return common(common(of_strain, of_heat), symmetry_of(tractions, scene_->grid));
}

/// region: all of the window.
Field State::total_stress(int body, bool with_tractions, const Box& region) const {
  const Grid& grid = scene_->grid;
  scene_->require_volume(body);
  const double sign = operators::shear_sign(body);
  if (!plastic[body] && !with_tractions) return Field(6 * region.volume_size(), 0.0);
  const operators::Heating heat = with_tractions ? heating[body] : operators::Heating{};
  const operators::Tractions loads = tractions_on(body);
  const auto of_tractions = [&] {
    return scene_->volume(body, region, Tensor::full, method, fft::Symmetry::none, heat)
        ->stress(nullptr, &loads, sign);
  };
  if (is_elsewhere(body)) {
    Field out = stress_of_strain(body, region);
    if (with_tractions) add(of_tractions(), out);
    return out;
  }
  if (!plastic[body]) return of_tractions();

  const fft::Symmetry symmetry = stress_symmetry(body, with_tractions);
  const auto history = unfolded(plastic[body], grid, symmetry);
  const Box box = whole_box(history->box(), grid, symmetry), around = region.united(box);
  Field out(6 * region.volume_size());
  const auto put = [&](const Box& whole) {
    const Box stored = part_of(whole, grid, symmetry);
    const operators::Tractions here = window(loads, grid, stored);
    const Field strain = six_components(history->strain(stored), history->tensor());
    const Field part = scene_->volume(body, whole, Tensor::full, method, symmetry, heat)
                           ->stress(strain.data(), with_tractions ? &here : nullptr, sign);
    put_unfolded(part, stored, symmetry, grid, region, out);
  };
  // In the box the very stress that the flow was computed with: the fast operator depends a little
  // on the period.
  const bool exact = method == operators::ResidualMethod::exact;
  if (exact || box != around) put(around);
  if (!exact) put(box);
  return out;
}

Field State::stress_of_strain(int body, const Box& region) const {
  scene_->require_volume(body);
  if (!plastic[body]) return Field(6 * region.volume_size(), 0.0);
  const auto history = unfolded(plastic[body], scene_->grid, fft::Symmetry::none);
  const Box around = acting_box(*history, region, scene_->reach);
  const auto operators =
      scene_->volume(body, around, Tensor::full, method, fft::Symmetry::none, {});
  const Field strain = six_components(history->strain(around), history->tensor());
  return cut(operators->stress(strain.data(), nullptr, 1.0), around, region);
}

Field State::stress(int body, Layers layers) const {
  const Box region = below(layers);
  Field stress = total_stress(body, true, region);
  const GivenHeat heat = given_heat(body);
  if (heat.is_on()) add(heat.stress(scene_->grid.z(region.nz), placement().offset[body]), stress);
  strength(body).add_stress(region, Tensor::full, stress);
  return stress;
}

Field State::residual_stress(int body, Layers layers) const {
  const Box region = below(layers);
  Field stress = total_stress(body, false, region);
  strength(body).add_stress(region, Tensor::full, stress);
  return stress;
}

Field State::residual_stress(int body, const Box& region) const {
  Field stress = stress_of_strain(body, region);
  strength(body).add_stress(region, Tensor::full, stress);
  return stress;
}

Strength State::strength(int body) const { return scene_->strength(body, travel); }

Field State::initial_stress(int body, Layers layers) const {
  return initial_stress(body, below(layers));
}

Field State::initial_stress(int body, const Box& region) const {
  scene_->require_volume(body);
  Field stress(6 * region.volume_size(), 0.0);
  strength(body).add_stress(region, Tensor::full, stress);
  return stress;
}

Field State::yield_factor(int body, const Box& region) const {
  scene_->require_volume(body);
  const Field factor = strength(body).factor(region);
  return factor.empty() ? Field(region.volume_size(), 1.0) : factor;
}

Field State::plastic_strain(int body, Layers layers) const {
  return plastic_strain(body, below(layers));
}

Field State::plastic_strain(int body, const Box& region) const {
  scene_->require_volume(body);
  if (!plastic[body]) return Field(6 * region.volume_size(), 0.0);
  const auto history = unfolded(plastic[body], scene_->grid, fft::Symmetry::none);
  return six_components(history->strain(region), history->tensor());
}

Field State::equivalent_plastic_strain(int body, Layers layers) const {
  return equivalent_plastic_strain(body, below(layers));
}

Field State::equivalent_plastic_strain(int body, const Box& region) const {
  scene_->require_volume(body);
  if (!plastic[body]) return Field(region.volume_size(), 0.0);
  return unfolded(plastic[body], scene_->grid, fft::Symmetry::none)->equivalent(region);
}

Box State::strain_beyond(int body) const {
  if (!plastic[body]) return {};
  const Grid& grid = scene_->grid;
  const auto history = plastic[body];
  const Box whole = whole_box(history->box(), grid, history->symmetry());
  Box seen{0, 0, grid.nx, grid.ny, grid.nz > 0 ? grid.nz : whole.nz};
  const Box flow = around(flow_boxes[body]);
  if (travel != Travel{} || (flow.i0 >= 0 && flow.i0 + flow.nx <= grid.nx)) {
    seen.i0 = whole.i0;
    seen.nx = whole.nx;
  }
  if (seen.contains(whole)) return {};
  const Box strained = whole_box(history->zones().around(), grid, history->symmetry());
  return seen.contains(strained) ? Box{} : strained;
}

std::size_t State::plastic_cells(int body) const {
  const auto whole = unfolded(plastic[body], scene_->grid, fft::Symmetry::none);
  return whole ? whole->yielded_cells() : 0;
}

double State::max_equivalent_plastic_strain(int body) const {
  return plastic[body] ? plastic[body]->max_equivalent() : 0.0;
}

double State::max_plastic_strain_magnitude(int body) const {
  return plastic[body] ? plastic[body]->max_strain() : 0.0;
}

Field State::backstress(int body, Layers layers) const { return backstress(body, below(layers)); }

Field State::backstress(int body, const Box& region) const {
  scene_->require_volume(body);
  const std::size_t cells = region.volume_size();
  const std::size_t terms = scene_->bodies[body].backstresses();
  Field out(6 * terms * cells, 0.0);
  if (!plastic[body] || terms == 0) return out;
  const Field deviators =
      unfolded(plastic[body], scene_->grid, fft::Symmetry::none)->backstress(region);
  for (std::size_t n = 0; n < terms; ++n) {
    complete(deviators.data() + 5 * n * cells, cells, out.data() + 6 * n * cells);
  }
  return out;
}

Field State::residual_displacement(int body, operators::Axis axis, const Box& region) const {
  const Box surface{region.i0, region.j0, region.nx, region.ny, 1};
  Field out(surface.surface_size(), 0.0);
  if (!plastic[body]) return out;
  const Grid& grid = scene_->grid;
  fft::Symmetry symmetry = plastic[body]->symmetry();
  const Box own = whole_box(plastic[body]->box(), grid, symmetry);
  // Its operators are there already.
  const bool inside = !is_elsewhere(body) && own.contains(surface);
  const Box around = inside ? own
                            : acting_box(*unfolded(plastic[body], grid, fft::Symmetry::none),
                                         surface, scene_->reach);
  if (whole_box(part_of(around, grid, symmetry), grid, symmetry) != around) {
    symmetry = fft::Symmetry::none;
  }
  const auto history = unfolded(plastic[body], grid, symmetry);
  const Box stored = part_of(around, grid, symmetry);
  const auto operators = scene_->volume(body, around, history->tensor(), method, symmetry,
                                        inside ? heating[body] : operators::Heating{});
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

Field State::surface_displacement(int body) const {
  Field out = residual_displacement(body, operators::Axis::z);
  if (scene_->media[body]->is_rigid()) return out;
  add(operators::surface_displacement(scene_->grid, *scene_->media[body], heating[body], tractions,
                                      operators::shear_sign(body), operators::Axis::z),
      out);
  if (const GivenHeat heat = given_heat(body); heat.is_on()) add(heat.displacement(), out);
  return out;
}

Field State::temperature(int body, Layers layers) const {
  scene_->require_volume(body);
  const Field pressure = tractions_on(body).pressure;
  const Box region = below(layers);
  const auto depths = scene_->grid.z(region.nz);
  Field rise = scene_->temperature(heating[body], region)->rise(pressure.data(), depths);
  const GivenHeat heat = given_heat(body);
  if (heat.is_on()) add(heat.temperature(depths, placement().offset[body]), rise);
  return rise;
}

Field State::surface_temperature(int body) const {
  const std::array surface{0.0};
  Field rise =
      operators::Temperature(scene_->grid, heating[body]).rise(tractions.pressure.data(), surface);
  if (const GivenHeat heat = given_heat(body); heat.is_on()) {
    add(heat.temperature(surface, placement().offset[body]), rise);
  }
  return rise;
}

}  // namespace samcontact::simulation
