// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes around required cells: disjoint, no larger than necessary, and stable once chosen.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

#include "samcontact/base/box_index.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"
#include "samcontact/simulation/cells/zones.hpp"

using namespace samcontact;
using namespace samcontact::simulation;

namespace {

const operators::BandSplit split;

/// Spots of all sizes in a square; if there are many, most of them overlap.
std::vector<Box> spots(int count, int window, unsigned seed) {
  std::mt19937 random(seed);
  const auto from_to = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  std::vector<Box> boxes;
  for (int n = 0; n < count; ++n) {
    const int nx = from_to(3, 30), ny = from_to(3, 30);
    boxes.push_back({from_to(0, window), from_to(0, window), nx, ny, from_to(1, 12)});
  }
  return boxes;
}

/// Depth of boxes below each column.
std::map<std::pair<int, int>, int> depths(const std::vector<Box>& boxes) {
  std::map<std::pair<int, int>, int> depth;
  for (const Box& box : boxes) {
    for (int i = box.i0; i < box.i0 + box.nx; ++i) {
      for (int j = box.j0; j < box.j0 + box.ny; ++j) {
        int& there = depth[{i, j}];
        there = std::max(there, box.nz);
      }
    }
  }
  return depth;
}

}  // namespace

TEST_CASE("merged boxes contain all cells of the given ones, and are stable") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const auto given = spots(1 + 4 * static_cast<int>(seed), 300, seed);
    const auto zones = merged(given, split);
    CHECK(are_disjoint(zones));
    const auto held = depths(zones);
    for (const auto& [column, depth] : depths(given)) {
      const auto found = held.find(column);
      REQUIRE(found != held.end());
      CHECK(found->second >= depth);
    }
    CHECK(merged(zones, split) == zones);
    // Cells that zones already contain change nothing, across zone boundaries too.
    auto more = zones;
    more.insert(more.end(), given.begin(), given.end());
    CHECK(merged(more, split) == zones);
  }
}

TEST_CASE("boxes connected from end to end are not all merged") {
  // Half of the square is covered, and most boxes overlap another.
  const auto given = spots(375, 500, 7);
  std::size_t needed = 0, held = 0;
  for (const auto& [column, depth] : depths(given)) needed += depth;
  const auto zones = merged(given, split);
  for (const Box& zone : zones) held += zone.volume_size();
  CHECK(zones.size() > 25);
  // Margins of neighbouring zones are wide: more of them are merged.
  CHECK(held < 4 * needed);
}

TEST_CASE("the index finds the same overlapping boxes as a search of all") {
  std::mt19937 random(7);  // NOLINT(bugprone-random-generator-seed): the same in every run
  std::vector<Box> boxes = spots(200, 500, 7);
  boxes.push_back({-200, -130, 700, 9, 1});  // across many tiles and negative cells
  BoxIndex index(boxes);
  for (int change = 0; change < 400; ++change) {
    const std::size_t number = random() % boxes.size();
    const Box box = spots(1, 500, random()).front().moved(-100, -100);
    if (change % 3 == 0) {
      index.add(box);
      boxes.push_back(box);
    } else {
      boxes[number] = change % 3 == 1 ? box : Box{};
      index.replace(static_cast<int>(number), boxes[number]);
    }
    std::vector<int> overlapping;
    for (int n = 0; n < static_cast<int>(boxes.size()); ++n) {
      if (!boxes[n].intersected(box).empty()) overlapping.push_back(n);
    }
    CHECK(index.overlapping(box) == overlapping);
  }
  std::erase_if(boxes, [](const Box& box) { return box.empty(); });
  CHECK(index.remaining() == boxes);
}
