// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/medium.hpp"

#include <stdexcept>

namespace samcontact::operators {

CellInfluence Medium::stress_influence(Traction, const Grid&, double) const {
  throw std::logic_error("this medium has no Fourier modes of stress");
}

CellInfluence Medium::residual_influence(Axis, const Grid&, int) const {
  throw std::logic_error("this medium has no Fourier modes of displacement");
}

SharedHeatMedium heat_of(const Medium& medium) {
  if (auto heat = medium.heat()) return heat;
  throw std::logic_error("this medium has no thermal coefficients");
}

std::optional<double> Medium::normal_ratio(Traction, const Medium& other) const {
  return *this == other ? std::optional(1.0) : std::nullopt;
}

}  // namespace samcontact::operators
