// SPDX-License-Identifier: GPL-3.0-or-later
// Cases for the thread sanitizer: a sum to which threads add without synchronisation, and loops
// separated by OpenMP barriers.
//
//   samcontact_race          the loops only
//   samcontact_race --race   the sum as well
#include <cstdio>
#include <vector>

namespace {

constexpr int count = 10'000;

/// Each element is written by one thread and read by another, after a barrier.
double neighbours() {
  std::vector<double> values(count), means(count);
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (int n = 0; n < count; ++n) values[n] = n;
#pragma omp for schedule(static)
    for (int n = 0; n < count; ++n) means[n] = 0.5 * (values[n] + values[count - 1 - n]);
  }
  return means[0];
}

double racing_sum() {
  double sum = 0.0;
#pragma omp parallel for schedule(static)
  for (int n = 0; n < count; ++n) sum += n;
  return sum;
}

}  // namespace

int main(int argc, char** /*argv*/) {
  std::printf("%g\n", neighbours());
  if (argc > 1) std::printf("%g\n", racing_sum());
  return 0;
}
