// SPDX-License-Identifier: GPL-3.0-or-later
// Scalar field over the cells of a box.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"

namespace samcontact::simulation {

/// [k][i][j].
struct BoxField {
  Box box;
  Field values;
  double at(int i, int j, int k) const {
    return values[(static_cast<std::size_t>(k) * box.nx + (i - box.i0)) * box.ny + (j - box.j0)];
  }
};

}  // namespace samcontact::simulation
