// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/relaxing_bodies.hpp"

namespace samcontact::simulation {

RelaxingBodies::RelaxingBodies(const IncrementTask& task) : from_(task.from) {
  for (int b = 0; b < 2; ++b) {
    const Relaxation& relaxation = task.setup().bodies[b].relaxation();
    if (!relaxation.is_on()) continue;
    steps_[b].emplace(relaxation, task.target.duration);
    compliances_[b] = steps_[b]->compliance;
  }
}

std::array<operators::Tractions, 2> RelaxingBodies::remembered() const {
  std::array<operators::Tractions, 2> tractions;
  for (int b = 0; b < 2; ++b) {
    if (!steps_[b] || !from_.memory[b]) continue;
    tractions[b] =
        simulation::remembered(*from_.memory[b], RelaxingBody(from_.setup(), b), *steps_[b]);
  }
  return tractions;
}

void RelaxingBodies::remember(const operators::Tractions& tractions, State& state) const {
  for (int b = 0; b < 2; ++b) {
    if (!steps_[b]) continue;
    state.memory[b] =
        after_step(from_.memory[b].get(), RelaxingBody(from_.setup(), b), *steps_[b], tractions);
  }
}

}  // namespace samcontact::simulation
