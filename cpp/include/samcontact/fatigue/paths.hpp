// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors of many cells at the moments of a cycle, passed to a task cell by cell.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::fatigue {

/// [moment][component][cell] of components xx, yy, zz, yz, xz, xy.
struct Paths {
  const double* values;
  std::size_t moments, cells;
};

/// Length of a row of a path: whole cache lines, filled with copies of the last moment, so that
/// loops over moments have no remainder.
inline std::size_t row_length(std::size_t moments) { return (moments + 7) / 8 * 8; }

/// Calls task(cell, {path of each of `given`}, work) for every cell. A path is [component][row];
/// `work` has the same number of rows. Digits do not depend on the number of threads.
template <std::size_t N, class Task>
void for_each_path(const std::array<Paths, N>& given, std::size_t work, const Task& task) {
  constexpr std::size_t together = 16;  // cells: two cache lines of a row are read in full
  constexpr std::size_t between = 512 * together;  // cells between checks for an interrupt
  const std::size_t moments = given[0].moments, cells = given[0].cells;
  const std::size_t row = row_length(moments), path = 6 * row;
  for (std::size_t first = 0; first < cells; first += between) {
    check_interrupt();
    const std::size_t end = std::min(first + between, cells);
    const std::ptrdiff_t groups = (end - first + together - 1) / together;
#pragma omp parallel if (static_cast<double>((end - first) * moments) * per_number > \
                             min_parallel_operations)
    {
      Field paths(N * together * path), rows(work * row);
#pragma omp for schedule(dynamic, 8)
      for (std::ptrdiff_t g = 0; g < groups; ++g) {
        const std::size_t begin = first + g * together, count = std::min(together, end - begin);
        for (std::size_t n = 0; n < N; ++n) {
          double* to = paths.data() + n * together * path;
          for (std::size_t t = 0; t < row; ++t) {
            for (std::size_t c = 0; c < 6; ++c) {
              const std::size_t at = std::min(t, moments - 1) * 6 + c;
              const double* from = given[n].values + at * cells + begin;
              for (std::size_t i = 0; i < count; ++i) to[i * path + c * row + t] = from[i];
            }
          }
        }
        for (std::size_t i = 0; i < count; ++i) {
          std::array<const double*, N> mine;
          for (std::size_t n = 0; n < N; ++n) mine[n] = paths.data() + (n * together + i) * path;
          task(begin + i, mine, rows.data());
        }
      }
    }
  }
}

}  // namespace samcontact::fatigue
