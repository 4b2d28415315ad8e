// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/reduce.hpp"

#include "samcontact/base/multiversion.hpp"

namespace samcontact {
namespace {

// Several running sums: a single one would wait for the latency of each addition.
constexpr std::size_t lanes = 16;

#define SAMCONTACT_DOT(A, B)                                                              \
  SAMCONTACT_MULTIVERSION                                                                 \
  double dot(const A* a, const B* b, std::size_t n) {                                     \
    double sums[lanes] = {};                                                              \
    std::size_t i = 0;                                                                    \
    for (; i + lanes <= n; i += lanes) {                                                  \
      for (std::size_t l = 0; l < lanes; ++l) {                                           \
        sums[l] += static_cast<double>(a[i + l]) * static_cast<double>(b[i + l]);         \
      }                                                                                   \
    }                                                                                     \
    for (std::size_t l = 0; i < n; ++i, ++l) sums[l] += static_cast<double>(a[i]) * b[i]; \
    double total = 0.0;                                                                   \
    for (const double sum : sums) total += sum;                                           \
    return total;                                                                         \
  }

SAMCONTACT_DOT(double, double)
SAMCONTACT_DOT(float, float)
SAMCONTACT_DOT(float, double)

template <class A, class B>
double chunked(const A* a, const B* b, std::size_t n) {
  return ordered_chunks(n, [&](std::size_t begin, std::size_t end) {
    return dot(a + begin, b + begin, end - begin);
  });
}

}  // namespace

double ordered_dot(const double* a, const double* b, std::size_t n) { return chunked(a, b, n); }
double ordered_dot(const float* a, const float* b, std::size_t n) { return chunked(a, b, n); }
double ordered_dot(const float* a, const double* b, std::size_t n) { return chunked(a, b, n); }

}  // namespace samcontact
