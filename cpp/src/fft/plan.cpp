// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/plan.hpp"

namespace samcontact::fft {

std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

int good_even_size(int n) {
  for (int m = n + n % 2;; m += 2) {
    int rest = m;
    for (const int p : {2, 3, 5, 7}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1) return m;
  }
}

}  // namespace samcontact::fft
