// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {
namespace {

std::map<Tile, std::vector<std::size_t>> sorted_by_tile(const std::vector<Box>& boxes) {
  std::map<Tile, std::vector<std::size_t>> by_tile;
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    for_each_tile(boxes[n], [&](const Tile& tile, const Box&) { by_tile[tile].push_back(n); });
  }
  return by_tile;
}

}  // namespace

Zones::Zones(std::vector<Box> boxes)
    : boxes_(std::move(boxes)), around_(simulation::around(boxes_)) {
  for (const Box& box : boxes_) first_.push_back(first_.back() + box.volume_size());
  if (count() > 1) by_tile_ = sorted_by_tile(boxes_);
}

std::size_t Zones::zone_of(std::size_t number) const {
  return std::upper_bound(first_.begin(), first_.end(), number) - first_.begin() - 1;
}

std::ptrdiff_t Zones::find(const Cell& cell) const {
  const auto near = by_tile_.find({tile_of(cell.i), tile_of(cell.j)});
  if (near == by_tile_.end()) return -1;
  for (const std::size_t zone : near->second) {
    const std::ptrdiff_t number = number_in(zone, cell);
    if (number >= 0) return number;
  }
  return -1;
}

Box around(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all = all.united(box);
  return all;
}

void copy_common(const double* from, const Zones& from_zones, double* to, const Zones& to_zones) {
  for (std::size_t a = 0; a < from_zones.count(); ++a) {
    for (std::size_t b = 0; b < to_zones.count(); ++b) {
      samcontact::copy_common(from + from_zones.first(a), from_zones.boxes()[a],
                              to + to_zones.first(b), to_zones.boxes()[b]);
    }
  }
}

bool are_disjoint(const std::vector<Box>& boxes) {
  for (const auto& [tile, near] : sorted_by_tile(boxes)) {
    for (auto a = near.begin(); a != near.end(); ++a) {
      for (auto b = near.begin(); b != a; ++b) {
        if (!boxes[*a].intersected(boxes[*b]).empty()) return false;
      }
    }
  }
  return true;
}

Zones covering(const Zones& a, const Zones& b, const Box& within) {
  std::map<Tile, Box> parts;
  for (const Zones* zones : {&a, &b}) {
    for (const Box& box : zones->boxes()) {
      for_each_tile(box.intersected(within), [&](const Tile& tile, const Box& part) {
        parts[tile] = parts[tile].united(part);
      });
    }
  }
  std::vector<Box> boxes;
  boxes.reserve(parts.size());
  for (const auto& [tile, part] : parts) boxes.push_back(part);
  return Zones(std::move(boxes));
}

}  // namespace samcontact::simulation
