// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface_influence.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace samcontact::operators {
namespace {

/// to += factor from; an empty `to` is zero.
void add_table(Field from, double factor, Field& to) {
  if (factor != 1.0) {
    for (double& value : from) value *= factor;
  }
  if (to.empty()) {
    to = std::move(from);
  } else {
    for (std::size_t n = 0; n < to.size(); ++n) to[n] += from[n];
  }
}

std::vector<int> ascending(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

void SurfaceInfluence::add(const SharedMedium& medium, double shear_x, const Heating& heating) {
  if (heating.is_on()) heated_.push_back({medium, heating});
  for (Body& body : bodies_) {
    if (*body.medium != *medium) continue;
    ++body.count;
    body.shear_x += shear_x;
    return;
  }
  bodies_.push_back({medium, 1, shear_x});
}

bool SurfaceInfluence::is_heated() const { return !heated_.empty(); }

Field SurfaceInfluence::elastic(double dx, double dy, const CellOffsets& offsets) const {
  Field table;
  for (const auto& [medium, count, shear_x] : bodies_) {
    if (medium->is_rigid()) continue;
    add_table(medium->compliance(Traction::pressure, Axis::z, dx, dy, offsets), count, table);
  }
  return table;
}

double SurfaceInfluence::wave_compliance(double wavenumber) const {
  double sum = 0.0;
  for (const auto& [medium, count, shear_x] : bodies_) {
    sum += count * medium->wave_compliance(wavenumber);
  }
  return sum;
}

Field SurfaceInfluence::even(double dx, double dy, const CellOffsets& offsets) const {
  Field table = elastic(dx, dy, offsets);
  if (heated_.empty()) return table;
  // Tables of heat ascend.
  const CellOffsets sorted{ascending(offsets.x), ascending(offsets.y)};
  const auto place = [](const std::vector<int>& values, int n) {
    return std::lower_bound(values.begin(), values.end(), n) - values.begin();
  };
  for (const auto& [medium, heating] : heated_) {
    const Field heat = medium->heat_displacement(heating, dx, dy, sorted.in_metres(dx, dy)).front();
    std::size_t at = 0;
    for (const int y : offsets.y) {
      const double* row = heat.data() + place(sorted.y, y) * sorted.x.size();
      for (const int x : offsets.x) table[at++] += row[place(sorted.x, x)];
    }
  }
  return table;
}

std::vector<ParityKernel> SurfaceInfluence::rest(double dx, double dy, int nx, int ny) const {
  std::array<Field, 4> sums;
  for (const auto& [medium, count, shear_x] : bodies_) {
    if (shear_x == 0 || medium->is_rigid()) continue;
    const auto offsets = CellOffsets::lattice(nx, ny);
    add_table(medium->compliance(Traction::shear_x, Axis::z, dx, dy, offsets), shear_x, sums[1]);
  }
  // Bodies of different media may cancel each other all the same.
  if (std::all_of(sums[1].begin(), sums[1].end(), [](double v) { return v == 0; })) sums[1].clear();
  for (const auto& [medium, heating] : heated_) {
    if (!heating.is_moving()) continue;
    auto parts = medium->heat_displacement(heating, dx, dy, Offsets::lattice(dx, dy, nx, ny));
    for (int flip = 1; flip < 4; ++flip) {
      if (!parts[flip].empty()) add_table(std::move(parts[flip]), 1.0, sums[flip]);
    }
  }
  std::vector<ParityKernel> rest;
  for (int flip = 1; flip < 4; ++flip) {
    if (sums[flip].empty()) continue;
    rest.push_back({{(flip & 1) != 0, (flip & 2) != 0, false}, std::move(sums[flip])});
  }
  return rest;
}

}  // namespace samcontact::operators
