// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/relaxing_bodies.hpp"

namespace samcontact::simulation {

RelaxingBodies::RelaxingBodies(const IncrementTask& task) : from_(task.from) {
  for (int b = 0; b < 2; ++b) {
    const Relaxation& relaxation = task.setup().bodies[b].relaxation();
    if (!relaxation.is_on()) continue;
    const RelaxationStep& step = steps_[b].emplace(relaxation, task.target.duration);
    compliances_[b] = step.compliance;
    if (!from_.memory[b]) continue;
    remembered_[b] = simulation::remembered(*from_.memory[b], RelaxingBody(from_.setup(), b), step);
  }
}

Field RelaxingBodies::slip(const operators::Tractions& before) const {
  Field slip;
  for (int b = 0; b < 2; ++b) {
    if (!steps_[b] || !from_.memory[b]) continue;
    const RelaxingBody body(from_.setup(), b);
    TrackTractions cause = remembered_[b];
    const TrackTractions past = equivalent(*from_.memory[b], body);
    cause.subtract(past.tractions);
    cause.add(compliances_[b], before, body.grid, true);
    const Field u = displacement(cause, body, std::array{operators::Axis::x, operators::Axis::y});
    slip.resize(u.size(), 0.0);
    contact::add_scaled(-operators::shear_sign(b), u, slip);
  }
  return slip;
}

void RelaxingBodies::remember(const operators::Tractions& tractions, State& state) const {
  for (int b = 0; b < 2; ++b) {
    const auto& step = steps_[b];
    if (!step) continue;
    state.memory[b] =
        after_step(from_.memory[b].get(), RelaxingBody(from_.setup(), b), *step, tractions);
  }
}

}  // namespace samcontact::simulation
