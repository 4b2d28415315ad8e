// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::contact {
namespace {

/// Eigenvalues of a kernel truncated by its period are raised to this fraction of the smallest of
/// the half-space, so that the preconditioner is positive definite for any shape of the cells.
constexpr double smallest_normal_fraction = 0.1;

/// Wavenumber of the shortest wave of the grid.
double shortest_wavenumber(double dx, double dy) {
  return std::numbers::pi * std::hypot(1 / dx, 1 / dy);
}

}  // namespace

Preconditioner::Preconditioner(const Grid& box, const operators::SurfaceInfluence& influence,
                               const operators::NearDisplacement& near)
    : transform_(box.nx, box.ny, operators::short_period_x(box), operators::short_period_y(box)),
      inverse_(near.is_exact() || influence.is_heated()
                   ? operators::periodic_spectrum(transform_, box,
                                                  [&](const operators::CellOffsets& offsets) {
                                                    return influence.elastic(box, offsets);
                                                  })
                   : near.spectrum()) {
  const double floor =
      smallest_normal_fraction * influence.wave_compliance(shortest_wavenumber(box.dx, box.dy));
  // The spectrum contains 1/(mx my) of the two transforms; so must the inverse.
  const double points = static_cast<double>(transform_.mx()) * transform_.my();
  for (double& value : inverse_) value = 1.0 / (std::max(value * points, floor) * points);
}

void Preconditioner::apply(const double* r, double* z, ComplexField& work) const {
  transform_.filter(r, inverse_.data(), z, work);
}

}  // namespace samcontact::contact
