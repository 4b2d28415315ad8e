// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/relaxing_bodies.hpp"

namespace samcontact::simulation {

RelaxingBodies::RelaxingBodies(const IncrementTask& task) : from_(task.from) {
  for (int b = 0; b < 2; ++b) {
    const Relaxation& relaxation = task.setup().bodies[b].relaxation();
    if (!relaxation.is_on()) continue;
    compliances_[b] = steps_[b].emplace(relaxation, task.target.duration).compliance;
  }
}

std::array<TrackTractions, 2> RelaxingBodies::remembered() const {
  std::array<TrackTractions, 2> tractions;
  for (int b = 0; b < 2; ++b) {
    const auto& step = steps_[b];
    if (!step || !from_.memory[b]) continue;
    tractions[b] = simulation::remembered(*from_.memory[b], RelaxingBody(from_.setup(), b), *step);
  }
  return tractions;
}

Field RelaxingBodies::slip(const operators::Tractions& before) const {
  Field slip;
  std::array<TrackTractions, 2> causes = remembered();
  for (int b = 0; b < 2; ++b) {
    if (!steps_[b] || !from_.memory[b]) continue;
    const RelaxingBody body(from_.setup(), b);
    TrackTractions& cause = causes[b];
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
