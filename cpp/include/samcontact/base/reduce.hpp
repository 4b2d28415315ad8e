// SPDX-License-Identifier: GPL-3.0-or-later
// Sums whose digits do not depend on the number of threads: fixed chunks, added in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace samcontact {

constexpr std::size_t reduce_chunk = 8192;
/// Rounding of a running sum grows with its terms: those of a mean over a thousand cells were off
/// by 1e-13. Blocks keep it at the longest of block, blocks a chunk, and chunks.
constexpr std::size_t reduce_block = 128;

/// Sum over chunks [begin, end) of 0..n-1 of partial(begin, end).
template <class Partial>
double ordered_chunks(std::size_t n, const Partial& partial) {
  const std::ptrdiff_t chunks = (n + reduce_chunk - 1) / reduce_chunk;
  std::vector<double> sums(chunks);
#pragma omp parallel for schedule(static) if (chunks > 4)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    sums[c] = partial(c * reduce_chunk, std::min(n, (c + 1) * reduce_chunk));
  }
  double total = 0.0;
  for (const double sum : sums) total += sum;
  return total;
}

/// sum_{i < n} term(i).
template <class Term>
double ordered_sum(std::size_t n, const Term& term) {
  return ordered_chunks(n, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t first = begin; first < end; first += reduce_block) {
      const std::size_t last = std::min(end, first + reduce_block);
      double part = 0.0;
      for (std::size_t i = first; i < last; ++i) part += term(i);
      sum += part;
    }
    return sum;
  });
}

/// sum_{i < n} a_i b_i.
double ordered_dot(const double* a, const double* b, std::size_t n);
double ordered_dot(const float* a, const float* b, std::size_t n);
double ordered_dot(const float* a, const double* b, std::size_t n);

}  // namespace samcontact
