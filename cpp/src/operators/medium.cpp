// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

CellOffsets CellOffsets::lattice(int nx, int ny) {
  CellOffsets offsets;
  for (int i = 0; i < nx; ++i) offsets.x.push_back(i);
  for (int j = 0; j < ny; ++j) offsets.y.push_back(j);
  return offsets;
}

Offsets CellOffsets::in_metres(double dx, double dy) const {
  Offsets offsets;
  for (const int i : x) offsets.x.push_back(i * dx);
  for (const int j : y) offsets.y.push_back(j * dy);
  return offsets;
}

std::optional<double> Medium::normal_ratio(Traction, const Medium& other) const {
  return *this == other ? std::optional(1.0) : std::nullopt;
}

kernels::Parity compliance_parity(Traction traction, Axis axis) {
  return {(traction == Traction::shear_x) != (axis == Axis::x),
          (traction == Traction::shear_y) != (axis == Axis::y), false};
}

}  // namespace samcontact::operators
