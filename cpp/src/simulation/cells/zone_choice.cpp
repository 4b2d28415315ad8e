// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/zone_choice.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "samcontact/base/box_index.hpp"
#include "samcontact/fft/plan.hpp"
#include "samcontact/operators/zones/zone_tables.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {
namespace {

using operators::Band;

/// Ratio of the points of a transform to those of a plane.
double padding(bool periodic) { return periodic ? 1.0 : 4.0; }

/// Margin around the required cells of a zone, and below them [cells].
constexpr int zone_margin = 1;

bool overlap(const Box& a, const Box& b) { return !a.intersected(b).empty(); }

/// Parts of a box outside another one, whose layers do not matter: whole rows in x, or in y.
std::vector<Box> parts_outside(const Box& box, const Box& other, bool rows_in_x) {
  const Box common = box.intersected(other);
  const int i1 = box.i0 + box.nx, j1 = box.j0 + box.ny;
  const int a1 = common.i0 + common.nx, b1 = common.j0 + common.ny;
  const auto from_to = [&](int i0, int to_i, int j0, int to_j) {
    return Box{i0, j0, to_i - i0, to_j - j0, box.nz};
  };
  std::vector<Box> parts;
  if (rows_in_x) {
    parts = {from_to(box.i0, i1, box.j0, common.j0), from_to(box.i0, i1, b1, j1),
             from_to(box.i0, common.i0, common.j0, b1), from_to(a1, i1, common.j0, b1)};
  } else {
    parts = {from_to(box.i0, common.i0, box.j0, j1), from_to(a1, i1, box.j0, j1),
             from_to(common.i0, a1, box.j0, common.j0), from_to(common.i0, a1, b1, j1)};
  }
  std::erase_if(parts, [](const Box& part) { return part.empty(); });
  return parts;
}

/// Smallest box around the cells of a box that no zone contains.
Box left_over(const Box& box, const BoxIndex& zones) {
  std::vector<Box> parts{box};
  for (const int number : zones.overlapping(box)) {
    const Box& zone = zones[number];
    if (zone.nz < box.nz) continue;
    std::vector<Box> left;
    for (const Box& part : parts) {
      const std::vector<Box> more =
          overlap(part, zone) ? parts_outside(part, zone, true) : std::vector{part};
      left.insert(left.end(), more.begin(), more.end());
    }
    parts = std::move(left);
  }
  return around(parts);
}

/// Merging and cutting of boxes to the zones of least cost.
class Merging {
 public:
  explicit Merging(const operators::BandSplit& split) : split_(split) {}

  /// Cost of all zones.
  double cost(const BoxIndex& zones) const;
  void unite(BoxIndex& boxes) const;
  /// Disjoint boxes with the same cells.
  BoxIndex made_disjoint(const std::vector<Box>& boxes) const;

 private:
  /// Cost of a zone with its margin.
  static double cost_within(const Box& margin, const Box& zone) {
    return static_cast<double>(fft::fast_plane_size(margin.nx)) * fft::fast_plane_size(margin.ny) *
           zone.nz;
  }
  /// Cost of few zones.
  double cost(const std::vector<Box>& zones) const;
  /// Cost of an isolated zone.
  double cost(const Box& zone) const { return cost(std::vector{zone}); }
  /// Zone and all cells that a box worth merging with it overlaps: at larger distances, the cells
  /// between both cost more than the margins and the cells by which planes are enlarged to sizes
  /// of fast transforms.
  Box within_reach(const Box& zone) const {
    const Box margin = widened(zone, split_.near_range);
    return widened(margin, split_.near_range + std::max(margin.nx, margin.ny) / 4);
  }
  /// Cheapest way to cover two overlapping boxes without merging them: one of them as deep as both
  /// require, and the part of the other outside it.
  std::vector<Box> parted(const Box& a, const Box& b) const;
  /// Whether two of the boxes cost less as one. A merged box that would overlap others is made only
  /// from two that overlap: otherwise it might be cut into these two again.
  bool better_as_one(const BoxIndex& boxes, int k, int l) const;
  /// Unites a box with one of a higher number than l. Returns this number; 0 if there is none.
  int unite_with_one_after(BoxIndex& boxes, int k, int l) const;

  const operators::BandSplit& split_;
};

double Merging::cost(const std::vector<Box>& zones) const {
  double sum = 0.0;
  for (const Box& zone : zones) {
    sum += cost_within(operators::zone_with_margin(zone, zones, split_), zone);
  }
  return sum;
}

double Merging::cost(const BoxIndex& zones) const {
  double sum = 0.0;
  for (int k = 0; k < zones.size(); ++k) {
    sum += cost_within(operators::zone_with_margin(zones[k], zones, split_), zones[k]);
  }
  return sum;
}

std::vector<Box> Merging::parted(const Box& a, const Box& b) const {
  std::vector<Box> best;
  for (const auto& [whole, cut] : {std::pair{a, b}, std::pair{b, a}}) {
    for (const bool rows_in_x : {true, false}) {
      std::vector<Box> boxes = parts_outside(cut, whole, rows_in_x);
      boxes.insert(boxes.begin(), {whole.i0, whole.j0, whole.nx, whole.ny, std::max(a.nz, b.nz)});
      if (best.empty() || cost(boxes) < cost(best)) best = std::move(boxes);
    }
  }
  return best;
}

bool Merging::better_as_one(const BoxIndex& boxes, int k, int l) const {
  const Box both = boxes[k].united(boxes[l]);
  if (overlap(boxes[k], boxes[l])) return cost(both) <= cost(parted(boxes[k], boxes[l]));
  if (cost(both) > cost(boxes[k]) + cost(boxes[l])) return false;
  return std::ranges::all_of(boxes.overlapping(both), [&](int n) { return n == k || n == l; });
}

int Merging::unite_with_one_after(BoxIndex& boxes, int k, int l) const {
  for (const int other : boxes.overlapping(within_reach(boxes[k]))) {
    if (other <= l || !better_as_one(boxes, k, other)) continue;
    boxes.replace(k, boxes[k].united(boxes[other]));
    boxes.remove(other);
    return other;
  }
  return 0;
}

void Merging::unite(BoxIndex& boxes) const {
  for (bool again = true; again;) {
    again = false;
    for (int k = 0; k < boxes.size(); ++k) {
      if (boxes[k].empty()) continue;
      for (int l = k; (l = unite_with_one_after(boxes, k, l)) > 0;) again = true;
    }
  }
}

BoxIndex Merging::made_disjoint(const std::vector<Box>& boxes) const {
  BoxIndex zones;
  std::vector<Box> waiting(boxes.rbegin(), boxes.rend());
  while (!waiting.empty()) {
    const Box box = left_over(waiting.back(), zones);
    waiting.pop_back();
    if (box.empty()) continue;
    const std::vector<int> others = zones.overlapping(box);
    if (others.empty()) {
      zones.add(box);
      continue;
    }
    const std::vector<Box> parts = parted(zones[others.front()], box);
    zones.remove(others.front());
    waiting.insert(waiting.end(), parts.rbegin(), parts.rend());
  }
  return zones;
}

/// Box around all columns connected to one column; the columns are removed.
Box taken_out(Columns& columns, int i, int j) {
  const Box& window = columns.window;
  Box box;
  std::vector<std::array<int, 2>> border{{i, j}};
  const auto take = [&](int a, int b) {
    int& depth = columns.depth[static_cast<std::size_t>(a) * window.ny + b];
    if (depth == 0) return false;
    box = box.united({window.i0 + a, window.j0 + b, 1, 1, depth});
    depth = 0;
    return true;
  };
  take(i, j);
  while (!border.empty()) {
    const auto [a, b] = border.back();
    border.pop_back();
    for (int x = std::max(0, a - 1); x <= std::min(window.nx - 1, a + 1); ++x) {
      for (int y = std::max(0, b - 1); y <= std::min(window.ny - 1, b + 1); ++y) {
        if (take(x, y)) border.push_back({x, y});
      }
    }
  }
  return box;
}

}  // namespace

std::vector<Box> boxes_around(const Columns& columns) {
  Columns left = columns;
  std::vector<Box> boxes;
  const Box& window = columns.window;
  for (int i = 0; i < window.nx; ++i) {
    for (int j = 0; j < window.ny; ++j) {
      if (left.depth[static_cast<std::size_t>(i) * window.ny + j] == 0) continue;
      const Box box = taken_out(left, i, j);
      boxes.push_back({box.i0 - zone_margin, box.j0 - zone_margin, box.nx + 2 * zone_margin,
                       box.ny + 2 * zone_margin, box.nz + zone_margin});
    }
  }
  return boxes;
}

Box widened(const Box& box, int cells) {
  return {box.i0 - cells, box.j0 - cells, box.nx + 2 * cells, box.ny + 2 * cells, box.nz + cells};
}

std::vector<Box> within_period(const std::vector<Box>& boxes, const Period& period) {
  if (!period.is_on()) return boxes;
  std::vector<Box> inside;
  for (Box box : boxes) {
    if (box.nx > period.x) box.i0 = 0, box.nx = period.x;
    if (box.ny > period.y) box.j0 = 0, box.ny = period.y;
    for (const int x : {-period.x, 0, period.x}) {
      for (const int y : {-period.y, 0, period.y}) {
        const Box part = box.moved(x, y).intersected({0, 0, period.x, period.y, box.nz});
        if (!part.empty()) inside.push_back(part);
      }
    }
  }
  return inside;
}

std::vector<Box> merged(const std::vector<Box>& boxes, const operators::BandSplit& split) {
  const Merging merging(split);
  BoxIndex needed;
  for (const Box& box : boxes) {
    const Box left = left_over(box, needed);
    if (!left.empty()) needed.add(left);
  }
  merging.unite(needed);
  BoxIndex zones = merging.made_disjoint(needed.remaining());
  merging.unite(zones);
  return zones.remaining();
}

double cost_of_zones(const std::vector<Box>& zones, const Box& surface,
                     const operators::BandSplit& split, bool periodic) {
  const Merging merging(split);
  Box all = surface;
  for (const Box& zone : zones) all = all.united(zone);
  const auto nodes = [&](int cells, Band band, int more) {
    return static_cast<double>(cells) / split.spacing(band) + (periodic ? 0 : more);
  };
  const auto planes = [&](Band band, int more) {
    return nodes(all.nx, band, more) * nodes(all.ny, band, more);
  };
  const double middle = planes(Band::middle, 2 * split.window_width);
  const double far = planes(Band::far, 2 * split.window_width + split.fading_nodes);
  return merging.cost(BoxIndex(zones)) + (middle + padding(periodic) * far) * all.nz;
}

double cost_of_box(const Box& box, bool periodic) {
  return padding(periodic) * box.nx * box.ny * box.layers();
}

}  // namespace samcontact::simulation
