// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface_influence.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "samcontact/kernels/corners.hpp"
#include "samcontact/kernels/far_displacement.hpp"
#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/operators/influence_lattice.hpp"

namespace samcontact::operators {
namespace {

using Corner = double (*)(double, double);

/// Corner sum of a cell of 1 by `aspect` at an offset in units of its width.
double corner_sum(Corner corner, double x, double y, double aspect) {
  return kernels::corner_sum_2d<1>(x, y, 0.5, 0.5 * aspect,
                                   [&](double s, double t) { return std::array{corner(s, t)}; })[0];
}

/// Displacements times `factor` at offsets in units of the width of a cell of 1 by `aspect`.
Field elastic_table(const Offsets& offsets, double aspect, double factor) {
  const auto& [x, y] = offsets;
  const kernels::FarDisplacement far(1.0, aspect);
  Field table(x.size() * y.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    double* row = table.data() + j * x.size();
    far.evaluate(x.data(), y[j], x.size(), row);
    if (y[j] >= far.begin()) continue;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] >= far.begin()) continue;
      row[i] = corner_sum(kernels::pressure_displacement, x[i], y[j], aspect);
    }
  }
  for (double& value : table) value *= factor / std::numbers::pi;
  return table;
}

/// Corner sums at the offsets i dx, j dy times dx.
Field corner_table(double dx, double dy, int nx, int ny, Corner corner, double factor) {
  const CornerLattice lattice{nx, ny, dy / dx};
  Field corners(lattice.size()), table(static_cast<std::size_t>(nx) * ny);
  lattice.evaluate<1>([&](double x, double y) { return std::array{corner(x, y)}; }, corners.data());
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
  return elastic_table(Offsets::lattice(1.0, dy / dx, nx, ny), dy / dx, normal_ * dx);
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
  Offsets in_widths = offsets;
  for (double& x : in_widths.x) x /= dx;
  for (double& y : in_widths.y) y /= dx;
  Field table = elastic_table(in_widths, dy / dx, normal_ * dx);
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
