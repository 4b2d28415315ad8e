// SPDX-License-Identifier: GPL-3.0-or-later
// When threads pay: below these sizes waking them costs more than they save. Digits do not depend
// on it.
#pragma once

#include <cstddef>

namespace samcontact {

/// Floating-point operations of a loop, a power counting as a hundred.
constexpr double worth_threads = 2.5e5;
/// Those of transforms and of the sweep through layers, for each number of a volume.
constexpr double per_number = 30;
/// Cells of a loop with a few operations each, or of a transform.
constexpr std::ptrdiff_t worth_threads_cells = 2'500;

/// action(i) for all cells i < n, each for itself.
template <class Action>
void for_each_cell(std::ptrdiff_t n, const Action& action) {
#pragma omp parallel for schedule(static) if (n >= worth_threads_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) action(i);
}

}  // namespace samcontact
