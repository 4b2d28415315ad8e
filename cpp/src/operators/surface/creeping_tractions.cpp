// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/creeping_tractions.hpp"

#include <utility>

namespace samcontact::operators {
namespace {

bool equal(const CreepingBody& a, const CreepingBody& b) {
  return *a.medium == *b.medium && a.creep.amounts == b.creep.amounts &&
         a.creep.distances == b.creep.distances && a.creep.towards_plus_x == b.creep.towards_plus_x;
}

/// Bodies with the factors of their displacement along an axis due to a traction.
std::vector<CreepingBody> relative(const std::array<CreepingBody, 2>& bodies, Traction kind,
                                   Axis axis) {
  std::vector<CreepingBody> out;
  for (int b = 0; b < 2; ++b) {
    const double sign = shear_sign(b);
    CreepingBody body = bodies[b];
    body.factor = sign_of(kind, sign) * (axis == Axis::z ? 1.0 : sign);
    out.push_back(std::move(body));
  }
  return out;
}

}  // namespace

CreepingTractions::CreepingTractions(const Grid& grid, const std::array<CreepingBody, 2>& bodies)
    : grid_(grid), convolution_(grid) {
  const bool alike = equal(bodies[0], bodies[1]);
  for (int in = 0; in < 3; ++in) {
    for (int out = 0; out < 3; ++out) {
      const Traction kind = all_tractions[in];
      const Axis axis = all_axes[out];
      const bool couples = (kind == Traction::pressure) != (axis == Axis::z);
      if (alike && couples) continue;  // equal bodies move alike
      for (ParityKernel& kernel :
           creep_kernels(grid, relative(bodies, kind, axis), convolution_, kind, axis)) {
        kernels_.push_back({out, in, std::move(kernel)});
      }
    }
  }
}

Field CreepingTractions::displacement(const Field& pressure, const Field& shear) const {
  Field acting = pressure;
  acting.insert(acting.end(), shear.begin(), shear.end());
  Field displacement(3 * grid_.surface_size());
  ComplexField work;
  convolution_.apply(kernels_, 3, acting.data(), 3, displacement.data(), work);
  return displacement;
}

}  // namespace samcontact::operators
