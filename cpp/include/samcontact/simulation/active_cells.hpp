// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of an increment that flow, or did in one of its iterations: the unknowns.
#pragma once

#include <cstdint>
#include <vector>

#include "samcontact/base/box.hpp"

namespace samcontact::simulation {

/// Appended to while an increment is solved, never reordered.
struct ActiveCells {
  struct Cell {
    std::uint8_t body;   // index among the inelastic bodies
    std::uint32_t cell;  // [k][i][j] of that body's box
  };
  std::vector<Cell> cells;

  std::size_t size() const { return cells.size(); }
  /// After a body's box has grown.
  void move(std::uint8_t body, const Box& from, const Box& to);
};

}  // namespace samcontact::simulation
