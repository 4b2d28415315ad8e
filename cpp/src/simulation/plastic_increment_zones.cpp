// SPDX-License-Identifier: GPL-3.0-or-later
// Small zones of an increment instead of one box.
#include "samcontact/simulation/plastic_increment.hpp"

#include <utility>

#include "samcontact/simulation/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

/// Of the work of one box, that of zones must be less than this part.
constexpr double worth = 0.7;
/// Cells by which a zone grows where its rim flows.
constexpr int growth = 2;

Box widened(const Box& box, int cells) {
  return {box.i0 - cells, box.j0 - cells, box.nx + 2 * cells, box.ny + 2 * cells, box.nz + cells};
}

}  // namespace

bool PlasticIncrement::may_split(const PlasticBody& body) const {
  const int b = body.index();
  return !settings_.one_zone && symmetry_ == fft::Symmetry::none &&
         from_.method == operators::ResidualMethod::fast && !scene_.grid.period.is_on() &&
         from_.travel == Travel{} && !target_.heating[b].is_on() && !heat_.has_past(b);
}

bool PlasticIncrement::is_worth_splitting(const PlasticBody& body,
                                          const std::vector<Box>& boxes) const {
  if (boxes.size() < 2) return false;
  const Box box = choice_.with_margin(around(boxes).united(window_of(tractions_, scene_.grid)));
  const Box one = choice_.fitted(box, body.zones().around());
  return cost_of_zones(boxes, Box::surface(scene_.grid)) < worth * cost_of_box(one);
}

void PlasticIncrement::take_up_zones(PlasticBody& body) {
  const auto& before = from_.flow_boxes[body.index()];
  if (may_split(body)) {
    std::vector<Box> boxes = before;
    if (boxes.size() == 1) {
      boxes = body.history_boxes();
      for (Box& box : boxes) box = widened(box, 1);
      boxes = merged(std::move(boxes));
    }
    if (is_worth_splitting(body, boxes)) return set_zones(body, Zones(std::move(boxes)), true);
  }
  const auto parts = parts_of(before, scene_.grid, symmetry_);
  set_zones(body, parts.size() == 1 ? Zones(parts) : Zones({choice_.fitted(around(parts), {})}));
}

bool PlasticIncrement::fit_zones(PlasticBody& body) {
  const bool first = body.zones().empty();
  if (scanned_ || !(body.is_split() || (first && may_split(body)))) return false;
  std::vector<Box> boxes = body.zones().boxes();
  const auto near = boxes_around(body.yielding_columns(*scans_[body.index()]));
  boxes.insert(boxes.end(), near.begin(), near.end());
  boxes = merged(std::move(boxes));
  if (first && !is_worth_splitting(body, boxes)) return false;
  if (boxes == body.zones().boxes()) return false;
  set_zones(body, Zones(std::move(boxes)), true);
  return true;
}

bool PlasticIncrement::grow_zones(PlasticBody& body, std::vector<Box> more) {
  if (more.empty()) return false;
  std::vector<Box> boxes = body.zones().boxes();
  boxes.insert(boxes.end(), more.begin(), more.end());
  set_zones(body, Zones(merged(std::move(boxes))), true);
  return true;
}

std::vector<Box> PlasticIncrement::rims_that_flow(std::size_t b) const {
  const Zones& zones = bodies_[b].zones();
  std::vector<Box> needed(zones.count());
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (active_.cells[n].body != b || active_.equivalent[n] == 0) continue;
    const std::uint32_t number = active_.cells[n].cell;
    const auto [i, j, k] = zones.cell(number);
    const std::size_t zone = zones.zone_of(number);
    const Box& box = zones.boxes()[zone];
    const bool inside = i > box.i0 && i < box.i0 + box.nx - 1 && j > box.j0 &&
                        j < box.j0 + box.ny - 1 && k < box.nz - 1;
    if (!inside) needed[zone] = needed[zone].united(widened({i, j, 1, 1, k + 1}, growth));
  }
  std::erase_if(needed, [](const Box& box) { return box.empty(); });
  return needed;
}

bool PlasticIncrement::grow_for_yield(PlasticBody& body) {
  Columns columns = body.yielding_columns(*scans_[body.index()]);
  for (const Box& zone : body.zones().boxes()) {
    const Box common = zone.intersected(columns.window);
    for (int i = common.i0; i < common.i0 + common.nx; ++i) {
      for (int j = common.j0; j < common.j0 + common.ny; ++j) {
        int& depth = columns.depth[static_cast<std::size_t>(i) * columns.window.ny + j];
        if (depth <= zone.nz) depth = 0;
      }
    }
  }
  return grow_zones(body, boxes_around(columns));
}

}  // namespace samcontact::simulation
