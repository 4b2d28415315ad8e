// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/coarsening.hpp"

#include <algorithm>
#include <cstddef>

#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

int half(int n) { return (n + 1) / 2; }

/// Second coarse cell from which fine cell i is interpolated; the first is i/2, with weight 3/4.
int neighbour(int i, int n) { return std::clamp(i / 2 + (i % 2 == 0 ? -1 : 1), 0, half(n) - 1); }

}  // namespace

Grid coarsened(const Grid& grid) {
  Grid coarse(half(grid.nx), half(grid.ny), 2 * grid.dx, 2 * grid.dy);
  coarse.period = {grid.period.x / 2, grid.period.y / 2, grid.period.reference};
  return coarse;
}

Field coarsened(const Grid& grid, const Field& field) {
  const int nx = half(grid.nx), ny = half(grid.ny);
  Field coarse(static_cast<std::size_t>(nx) * ny);
#pragma omp parallel for schedule(static) if (std::ssize(field) >= min_parallel_cells)
  for (int I = 0; I < nx; ++I) {
    for (int J = 0; J < ny; ++J) {
      double sum = 0.0;
      int cells = 0;
      for (int i = 2 * I; i < std::min(2 * I + 2, grid.nx); ++i) {
        for (int j = 2 * J; j < std::min(2 * J + 2, grid.ny); ++j, ++cells) {
          sum += field[static_cast<std::size_t>(i) * grid.ny + j];
        }
      }
      coarse[static_cast<std::size_t>(I) * ny + J] = sum / cells;
    }
  }
  return coarse;
}

Field refined(const Grid& grid, const Field& coarse) {
  const int ny = half(grid.ny);
  Field fine(grid.surface_size());
#pragma omp parallel for schedule(static) if (std::ssize(fine) >= min_parallel_cells)
  for (int i = 0; i < grid.nx; ++i) {
    const double* near = coarse.data() + static_cast<std::size_t>(i / 2) * ny;
    const double* far = coarse.data() + static_cast<std::size_t>(neighbour(i, grid.nx)) * ny;
    for (int j = 0; j < grid.ny; ++j) {
      const int J = j / 2, K = neighbour(j, grid.ny);
      fine[static_cast<std::size_t>(i) * grid.ny + j] =
          0.75 * (0.75 * near[J] + 0.25 * near[K]) + 0.25 * (0.75 * far[J] + 0.25 * far[K]);
    }
  }
  return fine;
}

Field filled_outwards(const Grid& grid, const Field& pressure, const Field& values) {
  Field filled = values;
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      const std::size_t at = static_cast<std::size_t>(i) * grid.ny + j;
      if (in_contact(pressure[at])) continue;
      double sum = 0.0;
      int count = 0;
      const auto add = [&](bool inside, std::size_t there) {
        if (!inside || !in_contact(pressure[there])) return;
        sum += values[there];
        ++count;
      };
      add(i > 0, at - grid.ny);
      add(i + 1 < grid.nx, at + grid.ny);
      add(j > 0, at - 1);
      add(j + 1 < grid.ny, at + 1);
      filled[at] = count > 0 ? sum / count : 0.0;
    }
  }
  return filled;
}

}  // namespace samcontact::contact
