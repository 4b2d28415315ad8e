// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a state in the zones of a body only, or in its one box.
#include "samcontact/simulation/state.hpp"

#include <algorithm>

#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/simulation/box_choice.hpp"
#include "samcontact/simulation/outside_strain.hpp"
#include "samcontact/simulation/tensor_fields.hpp"

namespace samcontact::simulation {

bool State::is_in_zones(int body) const {
  const auto& history = plastic[body];
  return history && flow_boxes[body].size() > 1 && history->symmetry() == fft::Symmetry::none &&
         method == operators::ResidualMethod::fast && scene_->may_split() &&
         (!scene_->grid.period.is_on() || travel == Travel{});
}

bool State::shows_zones(int body) const {
  return is_in_zones(body) && travel == Travel{} &&
         !plastic[body]->reaches_beyond(Zones(flow_boxes[body]));
}

std::vector<Box> State::zones(int body) const {
  if (!plastic[body]) return {};
  if (shows_zones(body)) return flow_boxes[body];
  const PlasticState& history = *plastic[body];
  const Box strained =
      whole_box(history.zones().around(), scene_->grid, history.symmetry()).intersected(below({}));
  return strained.empty() ? std::vector<Box>{} : std::vector{strained};
}

Field State::stress_in_zones(int body, bool with_tractions) const {
  const std::vector<Box> boxes = zones(body);
  if (boxes.empty()) return {};
  if (!shows_zones(body)) {
    return cut(with_tractions ? stress(body) : residual_stress(body), below({}), boxes.front());
  }
  const operators::Heating heat = with_tractions ? heating[body] : operators::Heating{};
  const auto tables = scene_->zone_tables(body, operators::Tensor::full, heat);
  const Zones zones(boxes);
  operators::ZoneOperators operators(tables, boxes);
  const Field strain = six_components(plastic[body]->strain(zones), plastic[body]->tensor());
  operators.transform(strain);
  Field out(6 * zones.cells());
  operators.for_each_layer(
      &strain, with_tractions ? tractions : operators::Tractions{}, operators::shear_sign(body),
      [&](std::size_t zone, int k, const double* stress) {
        const Box& box = zones.boxes()[zone];
        const std::size_t plane = box.surface_size();
        double* first = out.data() + 6 * zones.first(zone) + k * plane;
        for (int c = 0; c < 6; ++c) {
          std::copy_n(stress + c * plane, plane, first + c * box.volume_size());
        }
      });
  tables->forget_unused();
  const GivenHeat hot = given_heat(body);
  const bool has_heat = with_tractions && hot.is_on();
  const Field below = has_heat ? hot.stress(scene_->grid.z(zones.around().nz), 0.0) : Field{};
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    const Box& box = zones.boxes()[zone];
    Field start = has_heat ? below_in(below, 6, scene_->grid, box) : Field{};
    strength(body).add_stress(box, operators::Tensor::full, start);
    double* to = out.data() + 6 * zones.first(zone);
    for (std::size_t n = 0; n < start.size(); ++n) to[n] += start[n];
  }
  return out;
}

Box State::own_box(int body) const {
  if (!plastic[body] || is_elsewhere(body) || given_heat(body).is_on()) return {};
  const Grid& grid = scene_->grid;
  Box box = whole_box(plastic[body]->box(), grid, plastic[body]->symmetry());
  Box window = window_of(tractions_on(body), grid);
  window.nz = box.nz;
  if (!box.contains(window)) return {};
  if (grid.nz > 0) box.nz = std::min(box.nz, grid.nz);
  return box;
}

Field State::deviator_in_own_box(int body, bool with_tractions) const {
  const Box region = own_box(body);
  if (region.empty()) return {};
  const Grid& grid = scene_->grid;
  const fft::Symmetry symmetry = stress_symmetry(body, with_tractions);
  const auto history = unfolded(plastic[body], grid, symmetry);
  const Box& stored = history->box();
  const operators::Tractions here = window(tractions_on(body), grid, stored);
  const Field part = scene_
                         ->volume(body, whole_box(stored, grid, symmetry), history->tensor(),
                                  method, symmetry, heating[body])
                         ->stress(history->strain(stored).data(), with_tractions ? &here : nullptr,
                                  operators::shear_sign(body));
  Field out(6 * region.volume_size());
  put_unfolded(six_components(part, history->tensor()), stored, symmetry, grid, region, out);
  if (!scene_->bodies[body].has_initial_stress()) return out;
  Field start;
  strength(body).add_stress(region, operators::Tensor::deviator, start);
  start = six_components(std::move(start), operators::Tensor::deviator);
  for (std::size_t n = 0; n < out.size(); ++n) out[n] += start[n];
  return out;
}

Field State::residual_displacement(int body, operators::Axis axis) const {
  const Grid& grid = scene_->grid;
  const double offset = placement().offset[body];
  if (is_in_zones(body)) {
    const PlasticState& history = *plastic[body];
    const auto tables = scene_->zone_tables(body, history.tensor(), {});
    const Zones all = acting_zones(history, Zones(flow_boxes[body]), *tables, scene_->reach);
    operators::ZoneOperators zones(tables, all.boxes());
    zones.transform(history.strain(all), {&axis, 1});
    Field own(grid.surface_size());
    zones.displacement(axis, own.data());
    // They know of the grid only.
    return seen_from_body(own, grid, -offset, Beyond::as_last);
  }
  // A body between cells shows parts of what lies a row beyond the grid.
  const int more = offset == 0 ? 0 : 1;
  Grid wide = grid;
  wide.nx += 2 * more;
  const Box rows{-more, 0, wide.nx, grid.ny, 0};
  const Field seen = seen_from_body(residual_displacement(body, axis, rows), wide, -offset);
  const std::ptrdiff_t beyond = static_cast<std::ptrdiff_t>(more) * grid.ny;
  return {seen.begin() + beyond, seen.end() - beyond};
}

}  // namespace samcontact::simulation
