// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/increment_symmetry.hpp"

#include "samcontact/simulation/increment/slip_history.hpp"

namespace samcontact::simulation {

fft::Symmetry symmetry_of(const IncrementTask& task, const operators::Tractions& tractions,
                          const Sources& sources) {
  using fft::Symmetry;
  if (task.from.method == operators::ResidualMethod::exact) return Symmetry::none;
  Symmetry symmetry = task.setup().symmetry(task.from.travel);
  if (task.target.is_prescribed()) {
    symmetry = symmetry_of(tractions, task.setup().grid);
  } else {
    symmetry = common(symmetry, symmetry_of(task.target.drive));
  }
  if (task.setup().friction.sticks()) {
    symmetry = common(symmetry, symmetry_of(tangential_drive(task)));
    symmetry = common(symmetry, task.from.shear_symmetry);
  }
  symmetry = common(symmetry, sources.symmetry());
  symmetry = common(symmetry, symmetry_of(task.target.heating));
  symmetry = common(symmetry, task.target.past_symmetry);
  for (const auto* histories :
       {&task.from.plastic, &task.from.inclusions_flow, &task.from.matrix_flow}) {
    for (const auto& history : *histories) {
      if (history) symmetry = common(symmetry, history->symmetry());
    }
  }
  return symmetry;
}

bool bodies_are_mirror_images(const IncrementTask& task, const Sources& sources) {
  const auto& [upper, lower] = task.setup().bodies;
  if (task.setup().inclusions[0] || task.setup().inclusions[1]) return false;
  if (!upper.is_plastic() || upper != lower || task.setup().friction.slides() ||
      !is_free_of_shear(task))
    return false;
  if (task.target.heating[0] != task.target.heating[1] ||
      task.target.past[0] != task.target.past[1])
    return false;
  // Two softening laws cannot be compared.
  if (task.settings.softening[0] || task.settings.softening[1]) return false;
  // The worn depths may differ.
  if (!task.setup().reliefs[0].worn.empty() || !task.setup().reliefs[1].worn.empty()) return false;
  // Shear acts on the two bodies in opposite directions.
  if (!task.target.tractions.shear_x.empty() || !task.target.tractions.shear_y.empty())
    return false;
  // Stress that varies from cell to cell is not compared.
  if (!sources.all_smooth(0) || !sources.all_smooth(1)) return false;
  const auto offset = task.from.placement().offset;
  return offset[0] == offset[1] && same(task.from.plastic[0], task.from.plastic[1]);
}

}  // namespace samcontact::simulation
