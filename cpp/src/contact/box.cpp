// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/box.hpp"

#include <algorithm>

namespace samcontact::contact {
namespace {

/// A box pays when it has less than this share of the cells: it costs kernels of its own.
constexpr double worthwhile_share = 0.6;
constexpr int smallest_side = 64;

/// Widens a range of cells by a margin to a multiple of 8 within [0, n).
void widen(int n, int& start, int& length) {
  const int margin = 4 + length / 8;
  const int wide = std::min(std::max((length + 2 * margin + 7) / 8 * 8, smallest_side), n);
  start = std::clamp(start - (wide - length) / 2, 0, n - wide);
  length = wide;
}

/// Extends a range to hold another one; an empty one changes nothing.
void join(int other_start, int other_length, int& start, int& length) {
  if (other_length == 0) return;
  const int end = std::max(start + length, other_start + other_length);
  start = std::min(start, other_start);
  length = end - start;
}

}  // namespace

bool Box::contains(const Box& other) const {
  return i0 <= other.i0 && j0 <= other.j0 && i0 + nx >= other.i0 + other.nx &&
         j0 + ny >= other.j0 + other.ny;
}

Box possible_contact(int nx, int ny, const Field& pressure, const Field& gap) {
  int i0 = nx, i1 = -1, j0 = ny, j1 = -1;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const std::size_t at = static_cast<std::size_t>(i) * ny + j;
      if (pressure[at] <= 0 && gap[at] >= 0) continue;
      i0 = std::min(i0, i);
      i1 = std::max(i1, i);
      j0 = std::min(j0, j);
      j1 = std::max(j1, j);
    }
  }
  if (i1 < 0) return {0, 0, nx, ny};
  return {i0, j0, i1 - i0 + 1, j1 - j0 + 1};
}

Box with_margin(int nx, int ny, const Box& box, const Box& present) {
  Box wide = box;
  widen(nx, wide.i0, wide.nx);
  widen(ny, wide.j0, wide.ny);
  join(present.i0, present.nx, wide.i0, wide.nx);
  join(present.j0, present.ny, wide.j0, wide.ny);
  const double share = static_cast<double>(wide.nx) * wide.ny / (static_cast<double>(nx) * ny);
  return share < worthwhile_share ? wide : Box{0, 0, nx, ny};
}

Field extract(const Box& box, const Field& field, int ny) {
  Field part(static_cast<std::size_t>(box.nx) * box.ny);
  for (int i = 0; i < box.nx; ++i) {
    const auto row = field.begin() + static_cast<std::size_t>(box.i0 + i) * ny + box.j0;
    std::copy(row, row + box.ny, part.begin() + static_cast<std::size_t>(i) * box.ny);
  }
  return part;
}

Field embed(const Box& box, const Field& part, int ny, std::size_t size) {
  Field field(size, 0.0);
  for (int i = 0; i < box.nx; ++i) {
    const auto row = part.begin() + static_cast<std::size_t>(i) * box.ny;
    std::copy(row, row + box.ny,
              field.begin() + static_cast<std::size_t>(box.i0 + i) * ny + box.j0);
  }
  return field;
}

}  // namespace samcontact::contact
