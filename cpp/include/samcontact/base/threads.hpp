// SPDX-License-Identifier: GPL-3.0-or-later
// Minimum loop sizes for threads: below them, waking threads costs more than they save. Digits do
// not depend on it.
#pragma once

#include <cstddef>

namespace samcontact {

/// Floating-point operations of a loop; a power counts as a hundred.
constexpr double min_parallel_operations = 2.5e5;
/// Floating-point operations per number of a volume, in transforms and in the sweep through layers.
constexpr double per_number = 30;
/// Cells of a loop with a few operations each, or of a transform.
constexpr std::ptrdiff_t min_parallel_cells = 2'500;

/// Calls action(i) for all cells i < n independently.
template <class Action>
void for_each_cell(std::ptrdiff_t n, const Action& action) {
#pragma omp parallel for schedule(static) if (n >= min_parallel_cells)
  for (std::ptrdiff_t i = 0; i < n; ++i) action(i);
}

}  // namespace samcontact
