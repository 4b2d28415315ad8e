// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/zone_manager.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/simulation/body/far_inclusions.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

/// Material that past flow left at the yield stress creeps during unloading, far from the contact
/// too: flow below this fraction of the largest strain does not make a box grow beyond the grid.
constexpr double negligible_flow = 1e-4;

/// Relative change of load or approach up to which far inclusions are renewed by one step.
constexpr double change = 0.05;
/// Part of the cells of all inclusions up to which a box near the contact is worth it: the others
/// need two passes over all cells.
constexpr double max_near_cells = 0.5;

/// Part of the layers of a box that must lie above its inclusions for it to begin there.
constexpr double min_part_above = 0.25;

/// Relative change below which the extent of the pressure hardly changes.
constexpr double nearly_converged_change = 0.05;
/// Cells by which a zone grows if its outermost cells have plastic flow.
constexpr int growth = 2;

/// Whether zones contain all neighbours of a cell.
bool holds_around(const Zones& zones, const Cell& cell, const Period& period) {
  const auto within = [](int n, int length) { return length > 0 ? (n + length) % length : n; };
  for (int i = cell.i - 1; i <= cell.i + 1; ++i) {
    for (int j = cell.j - 1; j <= cell.j + 1; ++j) {
      if (zones.number({within(i, period.x), within(j, period.y), cell.k + 1}) < 0) return false;
    }
  }
  return true;
}

/// Whether a body with a history moves, and the contact does not change otherwise.
bool moves_steadily(const IncrementTask& task, const PlasticBody& body) {
  const State& from = task.from;
  const auto near = [](double a, double b) { return std::fabs(a - b) <= change * std::fabs(b); };
  const double normal = task.target.drive.normal.value;
  const bool steady = task.target.is_load()       ? near(normal, from.load)
                      : task.target.is_approach() ? near(normal, from.approach)
                                                  : false;
  const auto hot = [](const operators::Heating& heating) { return heating.factor != 0; };
  return steady && body.history() && from.advance.moves(body.index()) &&
         from.placement().offset[body.index()] == 0 &&
         !std::ranges::any_of(task.target.heating, hot);
}

/// Whether a body is warm from earlier heating or from slip.
bool keeps_heat(const IncrementTask& task, int body) {
  return task.target.past[body] != nullptr || !task.target.slip_power.empty();
}

std::invalid_argument unbounded_zone_error(const IncrementTask& task, const PlasticBody& body) {
  return std::invalid_argument(
      "at " + describe(task.target) + " the plastic zone of body " +
      std::to_string(body.index() + 1) +
      " is unbounded (whole half-space, or beyond three grid widths): reduce the load or widen the "
      "grid");
}

/// Box around the tractions before an increment of a motion and the last flow of the matrix; empty
/// if there are no tractions or if they move too far.
Box box_near_contact(const IncrementTask& task, const PlasticBody& body) {
  const State& from = task.from;
  Box near = box_near_tractions(from);
  const double by = from.advance.x[body.index()];
  if (near.empty() || std::fabs(by) > 0.25 * near.nx) return {};
  if (!from.last_flow) return near;
  const Inclusions& inclusions = *task.setup().inclusions[body.index()];
  const int first = from.placement().first[body.index()], steps = static_cast<int>(std::lround(by));
  for (const auto& [i, j, k] : from.last_flow->bodies[body.index()].cells) {
    // Estimates of inclusions are not flow.
    if (inclusions.at(i + steps, j, k, first, task.setup().grid.period) != nullptr) continue;
    near = near.united({i, j, 1, 1, k + 1});
  }
  return near;
}

/// Whole box around the zones of a body; empty if there are none.
Box whole_or_none(const BoxChoice& choice, const PlasticBody& body) {
  return body.zones().empty() ? Box{} : choice.whole(body.zones().around());
}

/// The box without the layers above all inclusions and all strain of a body, if these are many.
Box below_surface(const IncrementTask& task, const BoxChoice& choice, const PlasticBody& body,
                  Box box) {
  const Box mixed = body.cells().mixed().box();
  box.k0 = 0;
  if (mixed.empty() || task.settings.softening[body.index()]) return box;
  int top = choice.with_margin(mixed).k0;
  if (body.history()) top = std::min(top, body.history()->tiles().first_layer());
  if (top >= min_part_above * box.nz) box.k0 = top;
  return box;
}

}  // namespace

ZoneManager::ZoneManager(const IncrementTask& task, fft::Symmetry symmetry, const StartGuess& guess,
                         const operators::Tractions& tractions, const Sources& sources,
                         std::vector<PlasticBody>& bodies, ActiveCells& active)
    : task_(task),
      symmetry_(symmetry),
      choice_(task.setup().grid, symmetry),
      split_(task, symmetry, guess, tractions, sources),
      softening_(task),
      sources_(sources),
      bodies_(bodies),
      active_(active) {}

void ZoneManager::begin() {
  for (PlasticBody& body : bodies_) {
    if (take_up_near_inclusions(body) || take_up_inclusions_in_zones(body)) continue;
    if (body.history()) take_up_zones(body);
    take_up_inclusions(body);
  }
}

void ZoneManager::soften() {
  for (PlasticBody& body : bodies_) softening_.apply(body, whole_or_none(choice_, body));
}

void ZoneManager::set_zones(PlasticBody& body, const Zones& zones, bool split) {
  const Box whole = choice_.whole(zones.around());
  if (is_unbounded(whole, task_.setup().grid)) throw unbounded_zone_error(task_, body);
  body.set_zones(zones, split, sources_, active_);
  softening_.extend(body, whole);
}

Box ZoneManager::possible_contact_outside(const Field& gap) const {
  Box outside;
  if (gap.empty()) return outside;
  double reach = 0.0;
  for (const PlasticBody& body : bodies_) reach += body.surface().rim_displacement();
  for (const PlasticBody& body : bodies_)
    outside = outside.united(body.surface().possible_contact_outside(gap, reach));
  return outside;
}

bool ZoneManager::fit(const Field& gap) {
  const Grid& grid = task_.setup().grid;
  const Box outside = possible_contact_outside(gap);
  bool grown = false;
  for (PlasticBody& body : bodies_) {
    grown = fit_zones(body) || grown;
    if (body.is_split()) continue;
    const Box window = window_of(body.tractions(), grid);
    const Box now = whole_or_none(choice_, body);
    Box needed = now;
    // A body without scan flows in its inclusions only.
    if (!scanned_ && task_.scans[body.index()]) {
      const YieldScan& scan = *task_.scans[body.index()];
      // Under approach control the load is a result.
      if (!task_.target.is_approach() && body.search().yields_everywhere(body.tractions(), scan))
        throw unbounded_zone_error(task_, body);
      const Box near = body.search().near_yield(body.tractions(), scan, sources_);
      if (!near.empty()) needed = choice_.in_grid_or(now, needed.united(choice_.with_margin(near)));
    }
    if (needed.empty()) continue;
    // The stress is that of the tractions over the box: it must contain all of them.
    needed = needed.united(window);
    if (!outside.empty()) needed = needed.united(body.surface().below(outside));
    if (body.zones().count() == 1 && now.contains(needed)) continue;
    Box around = choice_.with_margin(window);
    if (needed.k0 > 0) around.nz = 0;  // only wider
    needed = choice_.in_grid_or(needed, needed.united(around));
    set_box(body, choice_.fitted(needed, body.zones().around()));
    grown = true;
  }
  scanned_ = true;
  return grown;
}

Box ZoneManager::needed_at_rim(std::size_t b, double negligible) const {
  const Zones& zones = bodies_[b].zones();
  const Box& box = zones.around();
  Box needed = box;
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (active_.cells[n].body != b || active_.equivalent[n] <= negligible) continue;
    needed = needed.united(choice_.rim_of(box, zones.cell(active_.cells[n].cell)));
  }
  return choice_.stored(needed);
}

bool ZoneManager::grow_at_rim() {
  bool grown = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    PlasticBody& body = bodies_[b];
    if (body.is_split()) {
      grown = grow_zones(body, rims_with_flow(b)) || grown;
      continue;
    }
    const Box box = body.zones().around();
    if (box.empty()) continue;
    const Box needed = choice_.in_grid_or(box, needed_at_rim(b, 0.0));
    if (box.contains(needed)) continue;
    set_box(body, choice_.fitted(choice_.whole(needed), box));
    grown = true;
  }
  return grown;
}

bool ZoneManager::grow_beyond() {
  bool grown = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    PlasticBody& body = bodies_[b];
    if (body.is_split()) {
      grown = grow_for_yield(body) || grown;
      continue;
    }
    if (!task_.scans[body.index()]) continue;
    const YieldScan& scan = *task_.scans[body.index()];
    if (body.search().yields_everywhere(body.tractions(), scan))
      throw unbounded_zone_error(task_, body);
    const Box box = body.zones().around();
    Box needed = whole_or_none(choice_, body);
    if (!box.empty()) {
      double largest = body.cells().strain_at_yield();
      if (body.history()) largest = std::max(largest, body.history()->tiles().max_equivalent());
      for (std::size_t n = 0; n < active_.size(); ++n) {
        if (active_.cells[n].body == b) largest = std::max(largest, active_.equivalent[n]);
      }
      needed = choice_.whole(needed_at_rim(b, negligible_flow * largest));
    }
    const Box below = body.search().yield_below(body.tractions(), scan, sources_);
    if (!below.empty()) needed = needed.united(choice_.with_margin(below));
    if (needed.empty()) continue;
    needed = needed.united(window_of(body.tractions(), task_.setup().grid));
    if (!box.empty() && choice_.whole(box).contains(needed)) continue;
    set_box(body, choice_.fitted(needed, box));
    grown = true;
  }
  return grown;
}

void ZoneManager::take_up_inclusions(PlasticBody& body) {
  const Box mixed = body.cells().mixed().box();
  if (mixed.empty()) return;
  const Box now = whole_or_none(choice_, body),
            needed = below_surface(task_, choice_, body, now.united(choice_.with_margin(mixed)));
  if (body.zones().count() == 1 && now.contains(needed)) return;
  set_box(body, choice_.fitted(needed, body.zones().around()));
}

bool ZoneManager::take_up_inclusions_in_zones(PlasticBody& body) {
  const MixedCells& mixed = body.cells().mixed();
  const bool rests = task_.from.travel == Travel{} && task_.from.advance == Travel{};
  if (mixed.box().empty() || !rests || !split_.is_allowed()) return false;
  std::vector<Box> boxes = split_.zones_to_begin_with(body);
  const auto around_each = boxes_around(mixed.columns());
  boxes.insert(boxes.end(), around_each.begin(), around_each.end());
  boxes = split_.merged_zones(boxes);
  const Box window = window_of(task_.from.tractions, task_.setup().grid);
  const Box one = choice_.fitted(choice_.with_margin(around(boxes).united(window)), {});
  if (!split_.cost_less(boxes, below_surface(task_, choice_, body, one))) return false;
  set_zones(body, Zones(std::move(boxes)), true);
  return true;
}

bool ZoneManager::take_up_near_inclusions(PlasticBody& body) {
  const Grid& grid = task_.setup().grid;
  const Settings& settings = task_.settings;
  const bool allowed = body.cells().mixed().is_on() && !settings.one_zone &&
                       symmetry_ == fft::Symmetry::none && grid.period.x == 0 &&
                       task_.from.method == operators::ResidualMethod::fast &&
                       !settings.softening[body.index()] &&
                       !(body.cells().mixed().expand() && keeps_heat(task_, body.index()));
  if (!allowed || !moves_steadily(task_, body)) return false;
  const Box required = choice_.in_grid_or({}, box_near_contact(task_, body));
  if (required.empty()) return false;
  const int b = body.index();
  if (const auto kept = kept_effect(task_.from, b, required)) {
    far_effect_[b] = kept;
    body.set_zones(Zones({kept->box}), body.history(), outside_of(*kept), sources_, active_);
    return true;
  }
  const double most =
      max_near_cells * static_cast<double>(body.cells().mixed().box().from_surface().volume_size());
  FarReach reach = reach_of_motion(task_.from, b, choice_.with_margin(required));
  const auto fit = [&] { reach.box = choice_.fitted(choice_.in_grid_or({}, reach.box), {}); };
  fit();
  if (static_cast<double>(reach.box.volume_size()) > most) {
    reach = {choice_.with_margin(required), Box::surface(grid)};
    fit();
    if (static_cast<double>(reach.box.volume_size()) > most) return false;
  }
  const Box near = reach.box;
  FarInclusions far = renew_far_inclusions(task_.from, b, *body.history(), reach, sources_);
  far_effect_[b] = far.effect;
  body.set_zones(Zones({near}), std::move(far.history), outside_of(*far.effect), sources_, active_);
  if (far.yielding.empty()) return true;
  const Box needed = choice_.in_grid_or(near, near.united(choice_.with_margin(far.yielding)));
  if (!near.contains(needed)) set_box(body, choice_.fitted(needed, near));
  return true;
}

std::shared_ptr<const FarEffect> ZoneManager::far_effect(const PlasticBody& body) const {
  const auto& effect = far_effect_[body.index()];
  const bool holds = effect && body.zones().boxes() == std::vector<Box>{effect->box};
  return holds ? effect : nullptr;
}

void ZoneManager::take_up_zones(PlasticBody& body) {
  if (may_split(body)) {
    std::vector<Box> boxes = split_.zones_to_begin_with(body);
    if (split_.is_worthwhile(body, boxes)) return set_zones(body, Zones(std::move(boxes)), true);
  }
  const auto parts = parts_of(task_.from.flow_boxes[body.index()], task_.setup().grid, symmetry_);
  const Box box = parts.size() == 1 ? parts.front() : choice_.fitted(around(parts), {});
  set_box(body, below_surface(task_, choice_, body, box));
}

bool ZoneManager::fit_zones(PlasticBody& body) {
  const bool first = body.zones().empty();
  if (scanned_ || !(body.is_split() || (first && may_split(body)))) return false;
  // Without scan a body flows in its inclusions only.
  if (!task_.scans[body.index()]) return false;
  std::vector<Box> boxes = body.zones().boxes();
  const auto near = boxes_around(
      body.search().yielding_columns(body.tractions(), *task_.scans[body.index()], sources_));
  boxes.insert(boxes.end(), near.begin(), near.end());
  boxes = split_.merged_zones(boxes);
  const bool may_merge = first || task_.from.travel != Travel{};
  if (may_merge && !split_.is_worthwhile(body, boxes)) {
    if (!first) set_box(body, choice_.fitted(body.zones().around(), {}));
    return !first;
  }
  if (boxes == body.zones().boxes()) return false;
  set_zones(body, Zones(std::move(boxes)), true);
  return true;
}

bool ZoneManager::grow_zones(PlasticBody& body, std::vector<Box> more) {
  if (more.empty()) return false;
  std::vector<Box> boxes = body.zones().boxes();
  boxes.insert(boxes.end(), more.begin(), more.end());
  set_zones(body, Zones(split_.merged_zones(boxes)), true);
  return true;
}

std::vector<Box> ZoneManager::rims_with_flow(std::size_t b) const {
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
    if (!inside && !holds_around(zones, {i, j, k}, task_.setup().grid.period))
      needed[zone] = needed[zone].united(widened({i, j, 1, 1, k + 1}, growth));
  }
  std::erase_if(needed, [](const Box& box) { return box.empty(); });
  return needed;
}

bool ZoneManager::grow_when_settled(double residual) {
  if (checked_outside_ || residual > nearly_converged_change) return false;
  checked_outside_ = true;
  bool grown = false;
  for (PlasticBody& body : bodies_) {
    if (body.is_split()) grown = grow_for_yield(body) || grown;
  }
  return grown;
}

bool ZoneManager::grow_for_yield(PlasticBody& body) {
  if (!task_.scans[body.index()]) return false;
  Columns columns =
      body.search().yielding_columns(body.tractions(), *task_.scans[body.index()], sources_);
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
