// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface_influence.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/operators/influence_lattice.hpp"

namespace samcontact::operators {
namespace {

/// Corner sums at the offsets i dx, j dy, in units of dx, times factor.
Field corner_table(double dx, double dy, int nx, int ny, double (*corner)(double, double),
                   double factor) {
  const CornerLattice lattice{nx, ny, dy / dx};
  Field corners(lattice.size()), table(static_cast<std::size_t>(nx) * ny);
  if (corner == kernels::pressure_displacement && dx == dy) {
    lattice.evaluate_symmetric(corner, corners.data());
  } else {
    lattice.evaluate<1>([&](double x, double y) { return std::array{corner(x, y)}; },
                        corners.data());
  }
  lattice.corner_sums(corners.data(), table.data(), nx, ny);
  for (double& value : table) value *= factor * dx / std::numbers::pi;
  return table;
}

void add(const Field& from, Field& to) {
  for (std::size_t n = 0; n < from.size(); ++n) to[n] += from[n];
}

}  // namespace

SurfaceInfluence::SurfaceInfluence(double normal_compliance, double shear_compliance)
    : normal_(normal_compliance), shear_(shear_compliance) {}

void SurfaceInfluence::add(const Heating& heating, double nu) {
  if (heating.is_on()) heated_.push_back({heating, nu});
}

bool SurfaceInfluence::has_rest() const {
  return shear_ != 0 || std::any_of(heated_.begin(), heated_.end(),
                                    [](const Heated& h) { return h.heating.is_moving(); });
}

Field SurfaceInfluence::elastic(double dx, double dy, int nx, int ny) const {
  return corner_table(dx, dy, nx, ny, kernels::pressure_displacement, normal_);
}

Field SurfaceInfluence::even(double dx, double dy, int nx, int ny) const {
  Field table = elastic(dx, dy, nx, ny);
  for (const auto& [heating, nu] : heated_) {
    operators::add(heat_displacement(heating, nu, dx, dy, Offsets::lattice(dx, dy, nx, ny)).front(),
                   table);
  }
  return table;
}

Field SurfaceInfluence::even(double dx, double dy, const Offsets& offsets) const {
  const double aspect = dy / dx;
  Field table;
  for (const double y : offsets.y) {
    for (const double x : offsets.x) {
      const auto corner = [&](double s, double t) {
        return kernels::pressure_displacement(x / dx + s, y / dx + t * aspect);
      };
      const double sum =
          (corner(0.5, 0.5) - corner(-0.5, 0.5)) - (corner(0.5, -0.5) - corner(-0.5, -0.5));
      table.push_back(normal_ * dx / std::numbers::pi * sum);
    }
  }
  if (heated_.empty()) return table;
  // Tables of heat ascend.
  const auto ascending = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  };
  const Offsets sorted{ascending(offsets.x), ascending(offsets.y)};
  const auto place = [](const std::vector<double>& values, double v) {
    return std::lower_bound(values.begin(), values.end(), v) - values.begin();
  };
  for (const auto& [heating, nu] : heated_) {
    const Field heat = heat_displacement(heating, nu, dx, dy, sorted).front();
    std::size_t at = 0;
    for (const double y : offsets.y) {
      for (const double x : offsets.x) {
        table[at++] += heat[place(sorted.y, y) * sorted.x.size() + place(sorted.x, x)];
      }
    }
  }
  return table;
}

std::vector<ParityKernel> SurfaceInfluence::rest(double dx, double dy, int nx, int ny) const {
  std::array<Field, 4> sums;
  if (shear_ != 0) {
    sums[1] = corner_table(dx, dy, nx, ny, kernels::shear_displacement, 0.5 * shear_);
  }
  for (const auto& [heating, nu] : heated_) {
    if (!heating.is_moving()) continue;
    auto parts = heat_displacement(heating, nu, dx, dy, Offsets::lattice(dx, dy, nx, ny));
    for (int flip = 1; flip < 4; ++flip) {
      if (sums[flip].empty()) {
        sums[flip] = std::move(parts[flip]);
      } else {
        operators::add(parts[flip], sums[flip]);
      }
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
