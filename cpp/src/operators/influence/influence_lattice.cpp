// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/influence/influence_lattice.hpp"

#include <algorithm>

namespace samcontact::operators {

void CornerLattice::corner_sums(const double* values, double* quarter, int hx, int hy) const {
  std::fill(quarter, quarter + static_cast<std::size_t>(hx) * hy, 0.0);
  for (int j = 0; j < ny; ++j) {
    const double* lower = values + static_cast<std::size_t>(j) * (nx + 1);
    const double* upper = lower + (nx + 1);
    double* row = quarter + static_cast<std::size_t>(j) * hx;
    for (int i = 0; i < nx; ++i) row[i] = (upper[i + 1] - upper[i]) - (lower[i + 1] - lower[i]);
  }
}

}  // namespace samcontact::operators
