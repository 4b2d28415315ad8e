// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fatigue/smallest_ball.hpp"

#include "samcontact/base/multiversion.hpp"

namespace samcontact::fatigue {

SAMCONTACT_MULTIVERSION
double squared_distances(const double* points, std::size_t count, int dimensions,
                         const double* centre, double* squares) {
  const double *x = points, *y = points + count;
  const double cx = centre[0], cy = centre[1];
  double largest = 0.0;
#pragma omp simd reduction(max : largest)
  for (std::size_t n = 0; n < count; ++n) {
    const double square = (x[n] - cx) * (x[n] - cx) + (y[n] - cy) * (y[n] - cy);
    squares[n] = square;
    largest = square > largest ? square : largest;
  }
  for (int d = 2; d < dimensions; ++d) {
    const double* row = points + d * count;
    const double c = centre[d];
    largest = 0.0;
#pragma omp simd reduction(max : largest)
    for (std::size_t n = 0; n < count; ++n) {
      const double square = squares[n] + (row[n] - c) * (row[n] - c);
      squares[n] = square;
      largest = square > largest ? square : largest;
    }
  }
  return largest;
}

}  // namespace samcontact::fatigue
