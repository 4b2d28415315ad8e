// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/state.hpp"

#include <stdexcept>
#include <utility>

namespace samcontact::simulation {
namespace {

/// Number of cells added before the first one, equal to that added after the last.
int cells_before(int from, int to) {
  if (to < from || (to - from) % 2 != 0) {
    throw std::invalid_argument(
        "a grid can be enlarged only by equal numbers of whole cells on both sides");
  }
  return (to - from) / 2;
}

}  // namespace

State State::widened(std::shared_ptr<const Setup> to) const {
  const Grid &from = setup_->grid, &grid = to->grid;
  const int i = cells_before(from.nx, grid.nx), j = cells_before(from.ny, grid.ny);
  if (past[0] || past[1] || softening[0] || softening[1]) {
    throw std::invalid_argument(
        "a grid with a heat history or thermal softening cannot be enlarged");
  }
  State state = *this;
  const Box before = Box::surface(from).moved(i, j);
  for (Field* field :
       {&state.tractions.pressure, &state.tractions.shear_x, &state.tractions.shear_y, &state.slip,
        &state.slip_power, &state.slip_rate, &state.plastic_slip}) {
    const std::size_t parts = field->size() / from.surface_size(), n = grid.surface_size();
    const Field known = std::exchange(*field, Field(parts * n, 0.0));
    for (std::size_t part = 0; part < parts; ++part) {
      insert(known.data() + part * from.surface_size(), before, field->data() + part * n,
             Box::surface(grid));
    }
  }
  state.contact_gap.clear();
  state.far_effect = {};
  for (int b = 0; b < 2; ++b) {
    const bool shared = b == 1 && plastic[0] == plastic[1];
    if (plastic[b]) state.plastic[b] = shared ? state.plastic[0] : plastic[b]->moved(i, j);
    for (auto* flow : {&state.inclusions_flow[b], &state.matrix_flow[b]}) {
      if (*flow) *flow = (*flow)->moved(i, j);
    }
    if (memory[b]) {
      TractionMemory wider = *memory[b];
      wider.box = wider.box.moved(i, j);
      state.memory[b] = std::make_shared<const TractionMemory>(std::move(wider));
    }
    if (eigenstrain[b]) state.eigenstrain[b] = eigenstrain[b]->moved(i, j);
    for (Box& box : state.flow_boxes[b]) box = box.moved(i, j);
  }
  if (last_flow) {
    PlasticIncrementGuess flow = *last_flow;
    for (auto& body : flow.bodies) {
      for (Cell& cell : body.cells) cell = {cell.i + i, cell.j + j, cell.k};
    }
    state.last_flow = std::make_shared<const PlasticIncrementGuess>(std::move(flow));
  }
  state.setup_ = std::move(to);
  return state;
}

}  // namespace samcontact::simulation
