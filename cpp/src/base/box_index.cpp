// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/box_index.hpp"

#include <algorithm>
#include <utility>

namespace samcontact {
namespace {

constexpr int tile_bits = 6;  // 64 cells

/// Calls use(key) for each tile that a box reaches.
template <class Use>
void for_each_tile(const Box& box, const Use& use) {
  if (box.empty()) return;
  const int i1 = (box.i0 + box.nx - 1) >> tile_bits, j1 = (box.j0 + box.ny - 1) >> tile_bits;
  for (int i = box.i0 >> tile_bits; i <= i1; ++i) {
    for (int j = box.j0 >> tile_bits; j <= j1; ++j) {
      use(std::uint64_t{static_cast<std::uint32_t>(i)} << 32 | static_cast<std::uint32_t>(j));
    }
  }
}

}  // namespace

BoxIndex::BoxIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  for (int number = 0; number < size(); ++number) list(number);
}

std::vector<int> BoxIndex::overlapping(const Box& box) const {
  std::vector<int> found;
  for_each_tile(box, [&](std::uint64_t tile) {
    const auto at = tiles_.find(tile);
    if (at == tiles_.end()) return;
    for (const int number : at->second) {
      if (!boxes_[number].intersected(box).empty()) found.push_back(number);
    }
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void BoxIndex::add(const Box& box) {
  boxes_.push_back(box);
  list(size() - 1);
}

void BoxIndex::replace(int number, const Box& box) {
  strike(number);
  boxes_[number] = box;
  list(number);
}

std::vector<Box> BoxIndex::remaining() const {
  std::vector<Box> boxes = boxes_;
  std::erase_if(boxes, [](const Box& box) { return box.empty(); });
  return boxes;
}

void BoxIndex::list(int number) {
  for_each_tile(boxes_[number], [&](std::uint64_t tile) { tiles_[tile].push_back(number); });
}

void BoxIndex::strike(int number) {
  for_each_tile(boxes_[number], [&](std::uint64_t tile) { std::erase(tiles_[tile], number); });
}

}  // namespace samcontact
