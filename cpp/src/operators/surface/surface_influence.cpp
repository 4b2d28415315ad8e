// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/surface_influence.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "samcontact/operators/medium/finite_body.hpp"

namespace samcontact::operators {
namespace {

void add_table(Field from, Field& to) {
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
  if (medium->is_rigid()) return;
  if (faced_body(*medium) && (shear_x != 0 || heating.is_on())) {
    throw std::invalid_argument(
        "free_faces cannot be combined with friction or heat: the displacement due to shear and "
        "heat near a free face is not known; set friction = 0, or omit free_faces");
  }
  bodies_.push_back({medium, shear_x, heating});
}

bool SurfaceInfluence::is_heated() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const Body& body) { return body.heating.is_on(); });
}

template <class Weight>
Field SurfaceInfluence::sum(Traction traction, const Grid& grid, const CellOffsets& offsets,
                            const Weight& weight) const {
  Field sum;
  std::vector<const Body*> left;
  left.reserve(bodies_.size());
  for (const Body& body : bodies_) left.push_back(&body);
  while (!left.empty()) {
    const Medium& medium = *left.front()->medium;
    double factor = 0.0;
    std::erase_if(left, [&](const Body* body) {
      const auto ratio = body->medium->normal_ratio(traction, medium);
      if (ratio) factor += weight(*body) * *ratio;
      return ratio.has_value();
    });
    if (factor == 0) continue;
    Field table = medium.compliance(traction, Axis::z, grid, offsets);
    for (double& value : table) value *= factor;
    add_table(std::move(table), sum);
  }
  return sum;
}

Field SurfaceInfluence::elastic(const Grid& grid, const CellOffsets& offsets) const {
  return sum(Traction::pressure, grid, offsets, [](const Body&) { return 1.0; });
}

double SurfaceInfluence::wave_compliance(double wavenumber) const {
  double sum = 0.0;
  for (const Body& body : bodies_) sum += body.medium->wave_compliance(wavenumber);
  return sum;
}

bool SurfaceInfluence::HeatTable::contains(const Grid& grid, const CellOffsets& offsets) const {
  const auto within = [](const std::vector<int>& values, int n) {
    return std::ranges::all_of(values, [n](int value) { return value >= 0 && value < n; });
  };
  return grid.dx == dx && grid.dy == dy && within(offsets.x, nx) && within(offsets.y, ny);
}

ParityParts SurfaceInfluence::heat(const Grid& grid, const Offsets& offsets) const {
  ParityParts sums;
  for (const auto& [medium, shear_x, heating] : bodies_) {
    if (!heating.is_on()) continue;
    auto parts = heat_of(*medium)->displacement(heating, grid.dx, grid.dy, offsets);
    for (int flip = 0; flip < 4; ++flip) {
      if (!parts[flip].empty()) add_table(std::move(parts[flip]), sums[flip]);
    }
  }
  return sums;
}

SurfaceInfluence SurfaceInfluence::tabulated(const Grid& grid, const KernelOffsets& offsets) const {
  SurfaceInfluence copy = *this;
  copy.heat_.reset();
  if (is_heated()) {
    const auto [nx, ny] = std::pair{offsets.nx, offsets.ny};
    copy.heat_ = std::make_shared<const HeatTable>(HeatTable{
        grid.dx, grid.dy, nx, ny, heat(grid, Offsets::lattice(grid.dx, grid.dy, nx, ny))});
  }
  return copy;
}

Field SurfaceInfluence::even(const Grid& grid, const CellOffsets& offsets) const {
  Field table = elastic(grid, offsets);
  if (!is_heated()) return table;
  if (heat_ && heat_->contains(grid, offsets)) {
    std::size_t at = 0;
    for (const int y : offsets.y) {
      const double* row = heat_->parts[0].data() + static_cast<std::size_t>(y) * heat_->nx;
      for (const int x : offsets.x) table[at++] += row[x];
    }
    return table;
  }
  // Tables of heat need ascending offsets.
  const CellOffsets sorted{ascending(offsets.x), ascending(offsets.y)};
  const auto place = [](const std::vector<int>& values, int n) {
    return std::lower_bound(values.begin(), values.end(), n) - values.begin();
  };
  const Field found = heat(grid, sorted.in_metres(grid.dx, grid.dy)).front();
  std::size_t at = 0;
  for (const int y : offsets.y) {
    const double* row = found.data() + place(sorted.y, y) * sorted.x.size();
    for (const int x : offsets.x) table[at++] += row[place(sorted.x, x)];
  }
  return table;
}

SharedEndEffects SurfaceInfluence::ends(const Grid& grid) const {
  std::vector<std::pair<Elastic, FreeFaces>> faced;
  for (const Body& body : bodies_) {
    if (const auto found = faced_body(*body.medium)) {
      faced.emplace_back(found->elastic, found->faces);
    }
  }
  return EndEffects::of(grid, faced);
}

std::vector<ParityKernel> SurfaceInfluence::rest(const Grid& grid,
                                                 const KernelOffsets& offsets) const {
  std::array<Field, 4> sums;
  sums[1] = sum(Traction::shear_x, grid, CellOffsets::lattice(offsets.nx, offsets.ny),
                [](const Body& body) { return body.shear_x; });
  const bool moving = std::ranges::any_of(
      bodies_, [](const Body& body) { return body.heating.is_on() && body.heating.is_moving(); });
  if (moving) {
    const bool known = heat_ && heat_->dx == grid.dx && heat_->dy == grid.dy &&
                       heat_->nx == offsets.nx && heat_->ny == offsets.ny;
    ParityParts parts =
        known ? heat_->parts
              : heat(grid, Offsets::lattice(grid.dx, grid.dy, offsets.nx, offsets.ny));
    for (int flip = 1; flip < 4; ++flip) {
      if (!parts[flip].empty()) add_table(std::move(parts[flip]), sums[flip]);
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
