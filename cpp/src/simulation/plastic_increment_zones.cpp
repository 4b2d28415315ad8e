// SPDX-License-Identifier: GPL-3.0-or-later
// Small zones of an increment instead of one box.
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/simulation/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

/// Of the work of one box, that of zones must be less than this part.
constexpr double worth = 0.7;
/// Where nothing is padded, rings and what zones do one by one count for more.
constexpr double worth_joined = 0.45;
/// Of bodies that move: each increment needs new zones, and once what lies outside of them.
constexpr double worth_moving = 0.4;
/// The relative change from which on pressures hardly reach further.
constexpr double settles = 0.05;
/// Cells by which a zone grows where its rim flows.
constexpr int growth = 2;

Box widened(const Box& box, int cells) {
  return {box.i0 - cells, box.j0 - cells, box.nx + 2 * cells, box.ny + 2 * cells, box.nz + cells};
}

/// As deep as some cells.
Columns columns_of(const std::vector<Cell>& cells) {
  Columns columns;
  for (const auto& [i, j, k] : cells) columns.window = columns.window.united({i, j, 1, 1, 1});
  const Box& window = columns.window;
  columns.depth.assign(window.surface_size(), 0);
  for (const auto& [i, j, k] : cells) {
    int& depth = columns.depth[static_cast<std::size_t>(i - window.i0) * window.ny + j - window.j0];
    depth = std::max(depth, k + 1);
  }
  return columns;
}

/// Whether zones hold all neighbours of a cell.
bool holds_around(const Zones& zones, const Cell& cell, const Period& period) {
  const auto within = [](int n, int length) { return length > 0 ? (n + length) % length : n; };
  for (int i = cell.i - 1; i <= cell.i + 1; ++i) {
    for (int j = cell.j - 1; j <= cell.j + 1; ++j) {
      if (zones.number({within(i, period.x), within(j, period.y), cell.k + 1}) < 0) return false;
    }
  }
  return true;
}

}  // namespace

bool PlasticIncrement::may_split() const {
  return !settings_.one_zone && symmetry_ == fft::Symmetry::none &&
         from_.method == operators::ResidualMethod::fast && scene_.may_split() &&
         (!scene_.grid.period.is_on() || is_cold_and_at_rest());
}

bool PlasticIncrement::is_cold_and_at_rest() const {
  const auto hot = [](const operators::Heating& heating) { return heating.factor != 0; };
  return from_.travel == Travel{} && from_.advance == Travel{} && !scene_.march.is_on() &&
         std::none_of(target_.heating.begin(), target_.heating.end(), hot);
}

std::vector<Box> PlasticIncrement::merged_zones(const std::vector<Box>& boxes) const {
  return merged(within_period(boxes, scene_.grid.period), scene_.split);
}

bool PlasticIncrement::is_worth_splitting(const PlasticBody& body,
                                          const std::vector<Box>& boxes) const {
  if (boxes.size() < 2) return false;
  const bool joined = scene_.grid.period.is_on();
  const double cost = cost_of_zones(boxes, Box::surface(scene_.grid), scene_.split, joined);
  const Box window = window_of(tractions_, scene_.grid), all = around(boxes);
  if (from_.travel != Travel{} && !window.empty()) {
    // One box leaves behind what does not flow.
    const Box needed = choice_.in_grid_or({}, window.united({0, 0, 0, 0, all.nz}));
    return cost <
           worth_moving * cost_of_box(choice_.fitted(choice_.with_margin(needed), {}), joined);
  }
  const Box box = choice_.with_margin(all.united(window));
  return cost < (joined ? worth_joined : worth) *
                    cost_of_box(choice_.fitted(box, body.zones().around()), joined);
}

std::vector<Box> PlasticIncrement::zones_to_begin_with(const PlasticBody& body) const {
  const auto& before = from_.flow_boxes[body.index()];
  const bool stays = from_.advance == Travel{};
  if (stays && before.size() > 1 && !body.has_strain_beyond(Zones(before))) return before;
  std::vector<Box> boxes = body.history_boxes();
  if (from_.travel != Travel{}) {
    const Grid& grid = scene_.grid;
    for (Box& box : boxes) box = box.intersected({0, box.j0, grid.nx, box.ny, box.nz});
    std::erase_if(boxes, [](const Box& box) { return box.empty(); });
  }
  for (Box& box : boxes) box = widened(box, 1);
  if (is_steady()) {
    const auto flow = boxes_around(columns_of(from_.last_flow->bodies[body.index()].cells));
    boxes.insert(boxes.end(), flow.begin(), flow.end());
  }
  return merged_zones(boxes);
}

void PlasticIncrement::take_up_zones(PlasticBody& body) {
  if (may_split()) {
    std::vector<Box> boxes = zones_to_begin_with(body);
    if (is_worth_splitting(body, boxes)) return set_zones(body, Zones(std::move(boxes)), true);
  }
  const auto parts = parts_of(from_.flow_boxes[body.index()], scene_.grid, symmetry_);
  set_zones(body, parts.size() == 1 ? Zones(parts) : Zones({choice_.fitted(around(parts), {})}));
}

bool PlasticIncrement::fit_zones(PlasticBody& body) {
  const bool first = body.zones().empty();
  if (scanned_ || !(body.is_split() || (first && may_split()))) return false;
  std::vector<Box> boxes = body.zones().boxes();
  const auto near = boxes_around(body.yielding_columns(*scans_[body.index()], heat_));
  boxes.insert(boxes.end(), near.begin(), near.end());
  boxes = merged_zones(boxes);
  const bool asks = first || from_.travel != Travel{};
  if (asks && !is_worth_splitting(body, boxes)) {
    if (!first) set_box(body, choice_.fitted(body.zones().around(), {}));
    return !first;
  }
  if (boxes == body.zones().boxes()) return false;
  set_zones(body, Zones(std::move(boxes)), true);
  return true;
}

bool PlasticIncrement::grow_zones(PlasticBody& body, std::vector<Box> more) {
  if (more.empty()) return false;
  std::vector<Box> boxes = body.zones().boxes();
  boxes.insert(boxes.end(), more.begin(), more.end());
  set_zones(body, Zones(merged_zones(boxes)), true);
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
    if (!inside && !holds_around(zones, {i, j, k}, scene_.grid.period))
      needed[zone] = needed[zone].united(widened({i, j, 1, 1, k + 1}, growth));
  }
  std::erase_if(needed, [](const Box& box) { return box.empty(); });
  return needed;
}

bool PlasticIncrement::look_beyond(double residual) {
  if (looked_ || residual > settles) return false;
  looked_ = true;
  bool grown = false;
  for (PlasticBody& body : bodies_) {
    if (body.is_split()) grown = grow_for_yield(body) || grown;
  }
  return grown;
}

bool PlasticIncrement::grow_for_yield(PlasticBody& body) {
  Columns columns = body.yielding_columns(*scans_[body.index()], heat_);
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
