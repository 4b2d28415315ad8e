// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/preconditioner.hpp"

#include <algorithm>

#include "samcontact/operators/surface/kernel_floor.hpp"

namespace samcontact::contact {

Preconditioner::Preconditioner(const Grid& box, const operators::SurfaceInfluence& influence,
                               const operators::NearDisplacement& near)
    : transform_(box.nx, box.ny, operators::short_period_x(box), operators::short_period_y(box)),
      inverse_(near.is_exact() || influence.is_heated()
                   ? operators::periodic_spectrum(transform_, box,
                                                  [&](const operators::CellOffsets& offsets) {
                                                    return influence.elastic(box, offsets);
                                                  })
                   : near.spectrum()) {
  const double floor = operators::kernel_floor(box, influence);
  // The spectrum contains 1/(mx my) of the two transforms; so must the inverse.
  const double points = static_cast<double>(transform_.mx()) * transform_.my();
  for (double& value : inverse_) value = 1.0 / (std::max(value * points, floor) * points);
}

void Preconditioner::apply(const double* r, double* z, ComplexField& work) const {
  transform_.filter(r, inverse_.data(), z, work);
}

}  // namespace samcontact::contact
