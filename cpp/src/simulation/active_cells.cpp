// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/active_cells.hpp"

namespace samcontact::simulation {

void ActiveCells::move(std::uint8_t body, const Box& from, const Box& to) {
  for (Cell& c : cells) {
    if (c.body != body) continue;
    const std::uint32_t j = c.cell % from.ny, ki = c.cell / from.ny;
    const std::uint32_t i = ki % from.nx, k = ki / from.nx;
    c.cell = (k * to.nx + i + (from.i0 - to.i0)) * to.ny + j + (from.j0 - to.j0);
  }
}

}  // namespace samcontact::simulation
