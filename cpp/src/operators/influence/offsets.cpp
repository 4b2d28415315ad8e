// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/influence/offsets.hpp"

namespace samcontact::operators {

Offsets Offsets::lattice(double dx, double dy, int nx, int ny) {
  Offsets offsets;
  for (int i = 0; i < nx; ++i) offsets.x.push_back(i * dx);
  for (int j = 0; j < ny; ++j) offsets.y.push_back(j * dy);
  return offsets;
}

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

}  // namespace samcontact::operators
