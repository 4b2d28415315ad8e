// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/box.hpp"

#include <algorithm>

namespace samcontact::contact {
namespace {

/// A box pays when it has less than this share of the cells: it costs kernels of its own.
constexpr double worthwhile_share = 0.6;
constexpr int smallest_side = 64;

/// Widens [first, last] by a margin to a multiple of 8 within [0, n).
void widen(int first, int last, int n, int& start, int& length) {
  const int extent = last - first + 1, margin = 4 + extent / 8;
  length = std::max((extent + 2 * margin + 7) / 8 * 8, smallest_side);
  start = std::clamp(first - (length - extent) / 2, 0, std::max(n - length, 0));
  length = std::min(length, n);
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
  const Box all{0, 0, nx, ny};
  if (i1 < 0) return all;
  Box box;
  widen(i0, i1, nx, box.i0, box.nx);
  widen(j0, j1, ny, box.j0, box.ny);
  const double share = static_cast<double>(box.nx) * box.ny / (static_cast<double>(nx) * ny);
  return share < worthwhile_share ? box : all;
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
