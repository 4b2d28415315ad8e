// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a state in the zones of a body only.
#include "samcontact/simulation/state.hpp"

#include <algorithm>

#include "samcontact/operators/zone_operators.hpp"
#include "samcontact/simulation/tensor_fields.hpp"

namespace samcontact::simulation {

bool State::is_in_zones(int body) const {
  const auto& history = plastic[body];
  return history && flow_boxes[body].size() > 1 && history->symmetry() == fft::Symmetry::none &&
         method == operators::ResidualMethod::fast && !scene_->grid.period.is_on();
}

bool State::shows_zones(int body) const {
  return is_in_zones(body) && travel == Travel{} && !heating[body].is_moving() && !past[body] &&
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
  return out;
}

}  // namespace samcontact::simulation
