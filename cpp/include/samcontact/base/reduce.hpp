// SPDX-License-Identifier: GPL-3.0-or-later
// Sums whose digits do not depend on the number of threads: fixed chunks, added in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace samcontact {

/// sum_{i < n} term(i).
template <class Term>
double ordered_sum(std::size_t n, const Term& term) {
  constexpr std::size_t chunk = 8192;
  const std::ptrdiff_t chunks = (n + chunk - 1) / chunk;
  std::vector<double> partial(chunks);
#pragma omp parallel for schedule(static) if (chunks > 4)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    double sum = 0.0;
    const std::size_t end = std::min(n, (c + 1) * chunk);
    for (std::size_t i = c * chunk; i < end; ++i) sum += term(i);
    partial[c] = sum;
  }
  double total = 0.0;
  for (const double sum : partial) total += sum;
  return total;
}

}  // namespace samcontact
