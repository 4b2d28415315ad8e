// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes listed by tiles of the surface, for a fast search of all those that overlap one box.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "samcontact/base/box.hpp"

namespace samcontact {

class BoxIndex {
 public:
  explicit BoxIndex(std::vector<Box> boxes = {});

  /// Numbers of the boxes that overlap a box, ascending.
  std::vector<int> overlapping(const Box& box) const;

  int size() const { return static_cast<int>(boxes_.size()); }
  /// Empty for a number that was removed.
  const Box& operator[](int number) const { return boxes_[number]; }
  void add(const Box& box);
  void replace(int number, const Box& box);
  void remove(int number) { replace(number, {}); }
  /// Boxes that were not removed, in the order of their numbers.
  std::vector<Box> remaining() const;

 private:
  void list(int number);
  void strike(int number);

  std::vector<Box> boxes_;
  std::unordered_map<std::uint64_t, std::vector<int>> tiles_;  // numbers of the boxes in each
};

}  // namespace samcontact
