// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/split_choice.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

/// Zones are used if their work is less than this fraction of that of one box.
constexpr double max_work_ratio = 0.7;
/// On periodic surfaces nothing is padded, so that margins and the work done zone by zone count for
/// more. At this ratio both took equally long on surfaces of `cached_plane` cells.
constexpr double max_work_ratio_periodic = 0.48;
/// Larger planes of one box exceed the cache. Planes of zones do not.
constexpr double cached_plane = 256.0 * 256.0;
/// Time of one box per cell: it grows with this power of the number of cells beyond
/// `cached_plane`, measured up to 1024 x 1024 cells.
constexpr double slowdown = 1.0 / 6;
/// Moving bodies need new zones in each increment, and once the effect of the strain outside them.
constexpr double max_work_ratio_moving = 0.4;

/// Columns down to some cells.
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

}  // namespace

bool SplitChoice::is_allowed() const {
  return !task_.settings.one_zone && sources_.all_smooth(0) && sources_.all_smooth(1) &&
         symmetry_ == fft::Symmetry::none && task_.from.method == operators::ResidualMethod::fast &&
         task_.setup().may_split() && (!task_.setup().grid.period.is_on() || is_cold_and_at_rest());
}

bool SplitChoice::is_cold_and_at_rest() const {
  const auto hot = [](const operators::Heating& heating) { return heating.factor != 0; };
  return task_.from.travel == Travel{} && task_.from.advance == Travel{} &&
         !task_.setup().transient_heating.is_on() &&
         std::none_of(task_.target.heating.begin(), task_.target.heating.end(), hot);
}

std::vector<Box> SplitChoice::merged_zones(const std::vector<Box>& boxes) const {
  return merged(within_period(boxes, task_.setup().grid.period), task_.setup().split);
}

bool SplitChoice::is_worthwhile(const PlasticBody& body, const std::vector<Box>& boxes) const {
  if (boxes.size() < 2) return false;
  const Box window = window_of(tractions_, task_.setup().grid), all = around(boxes);
  if (task_.from.travel != Travel{} && !window.empty()) {
    // One box does not include strain outside the present plastic flow.
    const Box needed = choice_.in_grid_or({}, window.united({0, 0, 0, 0, all.nz}));
    return cost_less(boxes, choice_.fitted(choice_.with_margin(needed), {}), max_work_ratio_moving);
  }
  const Box box = choice_.with_margin(all.united(window));
  return cost_less(boxes, choice_.fitted(box, body.zones().around()));
}

bool SplitChoice::cost_less(const std::vector<Box>& boxes, const Box& one) const {
  if (!task_.setup().grid.period.is_on()) return cost_less(boxes, one, max_work_ratio);
  const double planes = std::max(1.0, static_cast<double>(one.surface_size()) / cached_plane);
  return cost_less(boxes, one, max_work_ratio_periodic * std::pow(planes, slowdown));
}

bool SplitChoice::cost_less(const std::vector<Box>& boxes, const Box& one, double max_ratio) const {
  if (boxes.size() < 2) return false;
  const bool periodic = task_.setup().grid.period.is_on();
  const double cost =
      cost_of_zones(boxes, Box::surface(task_.setup().grid), task_.setup().split, periodic);
  return cost < max_ratio * cost_of_box(one, periodic);
}

std::vector<Box> SplitChoice::zones_to_begin_with(const PlasticBody& body) const {
  const auto& before = task_.from.flow_boxes[body.index()];
  const bool is_stationary = task_.from.advance == Travel{};
  if (is_stationary && before.size() > 1 &&
      !(body.history() && body.history()->reaches_beyond(Zones(before))))
    return before;
  std::vector<Box> boxes = body.history() ? body.history()->zones().boxes() : std::vector<Box>{};
  const Grid& grid = task_.setup().grid;
  // Strain far outside the grid moved there, or was set there.
  if (task_.from.travel != Travel{} || is_unbounded(around(boxes), grid)) {
    const bool across = !task_.from.travel.is_along_x();
    for (Box& box : boxes) {
      const int j0 = across ? 0 : box.j0, ny = across ? grid.ny : box.ny;
      box = box.intersected({0, j0, grid.nx, ny, box.nz});
    }
    std::erase_if(boxes, [](const Box& box) { return box.empty(); });
  }
  for (Box& box : boxes) box = widened(box, 1);
  if (guess_.is_steady()) {
    const auto flow = boxes_around(columns_of(task_.from.last_flow->bodies[body.index()].cells));
    boxes.insert(boxes.end(), flow.begin(), flow.end());
  }
  return merged_zones(boxes);
}

}  // namespace samcontact::simulation
