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
  const int ny = lattice_.ny();
#pragma omp parallel for schedule(static) if (lattice_.size() > 20'000)
  for (int i = 0; i < lattice_.nx(); ++i) {
    for (int slot = 0; slot < entries; ++slot) {
      const std::array<int, 2> step = offset(slot);
      const int di = step[0], dj = step[1];
      if (i + di < 0 || i + di >= lattice_.nx()) continue;
      const std::size_t row = static_cast<std::size_t>(i) * ny;
      const double* values = values_[slot].data() + row;
      const double* from = field.data() + static_cast<std::size_t>(i + di) * ny;
      double* to = sum.data() + row;
      const int first = std::clamp(-dj, 0, ny), end = std::clamp(ny - dj, first, ny);
      for (int j = first; j < end; ++j) to[j] += values[j] * from[j + dj];
      if (!lattice_.wraps()) continue;
      const auto across = [&](int j) { to[j] += values[j] * from[in_period(j + dj, ny)]; };
      for (int j = 0; j < first; ++j) across(j);
      for (int j = end; j < ny; ++j) across(j);
    }
  }
}

}  // namespace samcontact::film
