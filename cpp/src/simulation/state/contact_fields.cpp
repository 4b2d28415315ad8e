// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/state/contact_fields.hpp"

#include "samcontact/base/reduce.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"

namespace samcontact::simulation {

Field repulsion(const State& state) {
  const contact::ContactLaw& law = *state.setup().contact_law;
  return contact::repulsion(law, state.tractions.pressure, law.attracts() ? gap(state) : Field{});
}

double attraction_energy(const State& state) {
  const contact::ContactLaw& law = *state.setup().contact_law;
  if (!law.attracts()) return 0.0;
  const Field open = gap(state);
  return state.setup().grid.cell_area() *
         ordered_sum(open.size(), [&](std::size_t i) { return law.energy(open[i]); });
}

}  // namespace samcontact::simulation
