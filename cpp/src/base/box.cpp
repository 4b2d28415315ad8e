// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/box.hpp"

#include <algorithm>

#include "samcontact/base/threads.hpp"

namespace samcontact {
namespace {

/// Calls use(row of the small box, row of the large one) for every row of the small box.
template <class Use>
void for_each_row(const Box& small, const Box& large, const Use& use) {
  const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(small.layers()) * small.nx;
#pragma omp parallel for schedule(static) if (rows * small.ny >= min_parallel_cells)
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    const std::ptrdiff_t k = row / small.nx + small.k0 - large.k0, i = row % small.nx;
    const std::size_t other =
        static_cast<std::size_t>(k * large.nx + small.i0 + i - large.i0) * large.ny +
        (small.j0 - large.j0);
    use(static_cast<std::size_t>(row) * small.ny, other);
  }
}

}  // namespace

bool Box::contains(const Box& other) const {
  if (other.empty()) return other.nz <= nz;
  return i0 <= other.i0 && j0 <= other.j0 && i0 + nx >= other.i0 + other.nx &&
         j0 + ny >= other.j0 + other.ny && nz >= other.nz && (k0 <= other.k0 || other.nz == 0);
}

Box Box::intersected(const Box& other) const {
  const int i = std::max(i0, other.i0), j = std::max(j0, other.j0);
  Box common{i,
             j,
             std::max(0, std::min(i0 + nx, other.i0 + other.nx) - i),
             std::max(0, std::min(j0 + ny, other.j0 + other.ny) - j),
             std::min(nz, other.nz),
             std::max(k0, other.k0)};
  if (common.k0 > 0 && common.k0 >= common.nz) return {};
  return common;
}

Box Box::united(const Box& other) const {
  const int depth = std::max(nz, other.nz);
  if (empty() || other.empty()) {
    Box box = empty() ? other : *this;
    box.nz = depth;
    return box;
  }
  const int i = std::min(i0, other.i0), j = std::min(j0, other.j0);
  const int top = other.nz == 0 ? k0 : nz == 0 ? other.k0 : std::min(k0, other.k0);
  return {i,
          j,
          std::max(i0 + nx, other.i0 + other.nx) - i,
          std::max(j0 + ny, other.j0 + other.ny) - j,
          depth,
          top};
}

void insert(const double* small, const Box& from, double* large, const Box& into) {
  for_each_row(from, into, [&](std::size_t row, std::size_t other) {
    std::copy_n(small + row, from.ny, large + other);
  });
}

void extract(const double* large, const Box& from, double* small, const Box& into) {
  for_each_row(into, from, [&](std::size_t row, std::size_t other) {
    std::copy_n(large + other, into.ny, small + row);
  });
}

void copy_common(const double* from, const Box& from_box, double* to, const Box& to_box) {
  const Box common = from_box.intersected(to_box);
  if (common.empty()) return;
  const auto row = [&](const Box& box, int k, int i) {
    return (static_cast<std::size_t>(k - box.k0) * box.nx + i - box.i0) * box.ny +
           (common.j0 - box.j0);
  };
  for (int k = common.k0; k < common.nz; ++k) {
    for (int i = common.i0; i < common.i0 + common.nx; ++i) {
      std::copy_n(from + row(from_box, k, i), common.ny, to + row(to_box, k, i));
    }
  }
}

}  // namespace samcontact
