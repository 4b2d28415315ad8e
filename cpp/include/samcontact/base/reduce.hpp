// SPDX-License-Identifier: GPL-3.0-or-later
// Sums whose digits do not depend on the number of threads: fixed chunks, added in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace samcontact {

constexpr std::size_t reduce_chunk = 2048;
/// Number of running sums, each of every eighth term: a single sum would wait for the latency of
/// each addition.
constexpr std::size_t reduce_lanes = 8;
/// The rounding error of a running sum grows with the number of terms: means over a thousand cells
/// were off by 1e-13. With blocks the longest running sum is a block, the blocks of a chunk, or the
/// chunks.
constexpr std::size_t reduce_block = 32 * reduce_lanes;

/// Sum over chunks [begin, end) of 0..n-1 of partial(begin, end).
template <class Partial>
double ordered_chunks(std::size_t n, const Partial& partial) {
  const std::ptrdiff_t chunks = (n + reduce_chunk - 1) / reduce_chunk;
  std::vector<double> sums(chunks);
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    sums[c] = partial(c * reduce_chunk, std::min(n, (c + 1) * reduce_chunk));
  }
  double total = 0.0;
  for (const double sum : sums) total += sum;
  return total;
}

/// Sum of term(i) over first <= i < last, for at most one block of terms.
template <class Term>
double block_sum(std::size_t first, std::size_t last, const Term& term) {
  double lanes[reduce_lanes] = {};
  std::size_t i = first;
  for (; i + reduce_lanes <= last; i += reduce_lanes) {
    for (std::size_t l = 0; l < reduce_lanes; ++l) lanes[l] += term(i + l);
  }
  for (std::size_t l = 0; i < last; ++i, ++l) lanes[l] += term(i);
  double sum = 0.0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

/// sum_{i < n} term(i).
template <class Term>
double ordered_sum(std::size_t n, const Term& term) {
  return ordered_chunks(n, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t first = begin; first < end; first += reduce_block) {
      sum += block_sum(first, std::min(end, first + reduce_block), term);
    }
    return sum;
  });
}

/// Maximum of 0 and term(i), i < n.
template <class Term>
double largest_of(std::size_t n, const Term& term) {
  const std::ptrdiff_t chunks = (n + reduce_chunk - 1) / reduce_chunk;
  double largest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const std::size_t end = std::min(n, (c + 1) * reduce_chunk);
    double lanes[reduce_lanes] = {};
    std::size_t i = c * reduce_chunk;
    for (; i + reduce_lanes <= end; i += reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) {
        const double value = term(i + l);
        lanes[l] = value > lanes[l] ? value : lanes[l];
      }
    }
    for (; i < end; ++i) lanes[0] = std::max(lanes[0], term(i));
    for (const double lane : lanes) largest = std::max(largest, lane);
  }
  return largest;
}

/// sum_{i < n} a_i b_i.
double ordered_dot(const double* a, const double* b, std::size_t n);
double ordered_dot(const float* a, const float* b, std::size_t n);
double ordered_dot(const float* a, const double* b, std::size_t n);

}  // namespace samcontact
