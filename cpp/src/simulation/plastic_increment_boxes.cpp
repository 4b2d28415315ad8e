// SPDX-License-Identifier: GPL-3.0-or-later
// The boxes of an increment, and how they grow.
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>

#include "samcontact/simulation/fixed_point.hpp"

namespace samcontact::simulation {
namespace {

/// Material that past flow left at the yield stress creeps when it is unloaded, far from the
/// contact too: flow below this part of the largest strain does not make a box grow beyond the
/// grid.
constexpr double negligible_flow = 1e-4;

}  // namespace

void PlasticIncrement::set_zones(PlasticBody& body, const Zones& zones, bool split) {
  const Box whole = choice_.whole(zones.around());
  if (has_no_end(whole, scene_.grid)) throw flows_as_a_whole(body);
  body.set_zones(zones, split, sources_, active_);
  if (body.softening() && !body.softening()->box.contains(whole)) soften(body, whole);
}

std::invalid_argument PlasticIncrement::flows_as_a_whole(const PlasticBody& body) const {
  return std::invalid_argument(
      "at " + describe(target_) + " plastic flow of body " + std::to_string(body.index() + 1) +
      " has no end: the half-space yields as a whole, or farther than three widths of the grid. "
      "Take a smaller load, or a wider grid");
}

/// Its whole box; empty before there is one.
Box PlasticIncrement::whole_or_none(const PlasticBody& body) const {
  return body.zones().empty() ? Box{} : choice_.whole(body.zones().around());
}

bool PlasticIncrement::may_touch_outside(const Field& gap) const {
  if (gap.empty()) return false;
  double reach = 0.0;
  for (const PlasticBody& body : bodies_) reach += body.rim_displacement();
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [&](const PlasticBody& body) { return body.may_touch_outside(gap, reach); });
}

bool PlasticIncrement::fit_boxes(const Field& gap) {
  const Grid& grid = scene_.grid;
  const bool touches = may_touch_outside(gap);
  bool grown = false;
  for (PlasticBody& body : bodies_) {
    grown = fit_zones(body) || grown;
    if (body.is_split()) continue;
    const Box window = window_of(body.tractions(), grid);
    const Box now = whole_or_none(body);
    Box needed = now;
    if (!scanned_) {
      const YieldScan& scan = *scans_[body.index()];
      // The load of a given approach comes out of the solution.
      if (!target_.is_approach() && body.yields_everywhere(scan)) throw flows_as_a_whole(body);
      const Box near = body.near_yield(scan, heat_);
      if (!near.empty()) needed = choice_.in_grid_or(now, needed.united(choice_.with_margin(near)));
    }
    if (needed.empty()) continue;
    // The stress is that of the tractions over the box: it must hold all of them.
    needed = needed.united(window);
    if (touches) needed = needed.united(body.seen_surface());
    if (body.zones().count() == 1 && now.contains(needed)) continue;
    needed = choice_.in_grid_or(needed, needed.united(choice_.with_margin(window)));
    set_box(body, choice_.fitted(needed, body.zones().around()));
    grown = true;
  }
  scanned_ = true;
  return grown;
}

Box PlasticIncrement::needed_at_rim(std::size_t b, double negligible) const {
  const Zones& zones = bodies_[b].zones();
  const Box& box = zones.around();
  Box needed = box;
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (active_.cells[n].body != b || active_.equivalent[n] <= negligible) continue;
    needed = needed.united(choice_.rim_of(box, zones.cell(active_.cells[n].cell)));
  }
  return choice_.stored(needed);
}

bool PlasticIncrement::grow_at_rim() {
  bool grown = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    PlasticBody& body = bodies_[b];
    if (body.is_split()) {
      grown = grow_zones(body, rims_that_flow(b)) || grown;
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

bool PlasticIncrement::grow_beyond() {
  bool grown = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    PlasticBody& body = bodies_[b];
    if (body.is_split()) {
      grown = grow_for_yield(body) || grown;
      continue;
    }
    const YieldScan& scan = *scans_[body.index()];
    if (body.yields_everywhere(scan)) throw flows_as_a_whole(body);
    const Box box = body.zones().around();
    Box needed = whole_or_none(body);
    if (!box.empty()) {
      double largest = body.strain_scale();
      for (std::size_t n = 0; n < active_.size(); ++n) {
        if (active_.cells[n].body == b) largest = std::max(largest, active_.equivalent[n]);
      }
      needed = choice_.whole(needed_at_rim(b, negligible_flow * largest));
    }
    const Box below = body.yield_below(scan, heat_);
    if (!below.empty()) needed = needed.united(choice_.with_margin(below));
    if (needed.empty()) continue;
    needed = needed.united(window_of(body.tractions(), scene_.grid));
    if (!box.empty() && choice_.whole(box).contains(needed)) continue;
    set_box(body, choice_.fitted(needed, box));
    grown = true;
  }
  return grown;
}

}  // namespace samcontact::simulation
