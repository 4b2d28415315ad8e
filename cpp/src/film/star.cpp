// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/star.hpp"

#include <algorithm>

namespace samcontact::film {
Star::Star(const Lattice& lattice) : lattice_(lattice) {
  for (Field& values : values_) values.assign(lattice.size(), 0.0);
}

void Star::clear() {
  for (Field& values : values_) std::fill(values.begin(), values.end(), 0.0);
}

std::array<int, 2> Star::offset(int slot) {
  if (slot == 0) return {0, 0};
  const int along = (slot - 1) % 4, step = along < reach ? along - reach : along - reach + 1;
  return (slot - 1) / 4 == 0 ? std::array{step, 0} : std::array{0, step};
}

void Star::add_product(const Field& field, Field& sum) const {
#pragma omp parallel for schedule(static) if (lattice_.size() > 20'000)
  for (int i = 0; i < lattice_.nx(); ++i) {
    for (int slot = 0; slot < entries; ++slot) {
      const auto [di, dj] = offset(slot);
      if (i + di < 0 || i + di >= lattice_.nx()) continue;
      for (int j = 0; j < lattice_.ny(); ++j) {
        const std::ptrdiff_t from = lattice_.at(i + di, j + dj);
        if (from < 0) continue;
        const std::ptrdiff_t row = lattice_.at(i, j);
        sum[row] += values_[slot][row] * field[from];
      }
    }
  }
}

}  // namespace samcontact::film
