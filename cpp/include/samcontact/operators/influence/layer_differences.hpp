// SPDX-License-Identifier: GPL-3.0-or-later
// Cuboid influence coefficients layer by layer: the third difference of the corner sums.
#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/operators/influence/influence_lattice.hpp"

namespace samcontact::operators {

/// For n = 0..count-1 calls use(n, values(level n+1) - values(level n)), where values(m) are N
/// corner functions on the lattice at depth z(m). Each thread takes a contiguous run of layers, so
/// that a level is evaluated once, or twice where two runs meet. exchanged: see CornerLattice.
template <std::size_t N, class Depth, class Corner, class Use>
void for_each_layer_difference(const CornerLattice& lattice, int count, const Depth& z,
                               const Corner& corner, const Use& use,
                               const std::array<std::size_t, N>* exchanged = nullptr) {
  check_interrupt();
#pragma omp parallel
  {
    int thread = 0, threads = 1;
#ifdef _OPENMP
    thread = omp_get_thread_num();
    threads = omp_get_num_threads();
#endif
    const int begin = count * thread / threads, end = count * (thread + 1) / threads;
    Field lower(N * lattice.size()), upper(N * lattice.size());
    const auto evaluate = [&](int level, Field& values) {
      const double depth = z(level);
      lattice.evaluate<N>([&](double x, double y) { return corner(x, y, depth); }, values.data(),
                          exchanged);
    };
    if (begin < end) evaluate(begin, lower);
    for (int n = begin; n < end; ++n) {
      evaluate(n + 1, upper);
      std::transform(upper.begin(), upper.end(), lower.begin(), lower.begin(), std::minus<>());
      use(n, lower.data());
      std::swap(lower, upper);
    }
  }
}

}  // namespace samcontact::operators
