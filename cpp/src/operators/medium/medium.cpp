// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/medium.hpp"

#include <stdexcept>

namespace samcontact::operators {

CellInfluence Medium::stress_influence(Traction, const Grid&, double) const {
  throw std::logic_error("a medium does not know the stress of waves");
}

CellInfluence Medium::residual_influence(Axis, const Grid&, int) const {
  throw std::logic_error("a medium does not know the displacement of waves");
}

SharedHeatMedium heat_of(const Medium& medium) {
  if (auto heat = medium.heat()) return heat;
  throw std::invalid_argument(
      "a layered body has no frictional heat: give a homogeneous body instead");
}

std::optional<double> Medium::normal_ratio(Traction, const Medium& other) const {
  return *this == other ? std::optional(1.0) : std::nullopt;
}

}  // namespace samcontact::operators
