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

std::array<operators::Tractions, 2> RelaxingBodies::remembered() const {
  std::array<operators::Tractions, 2> tractions;
  for (int b = 0; b < 2; ++b) {
    const auto& step = steps_[b];
    if (!step || !from_.memory[b]) continue;
    tractions[b] = simulation::remembered(*from_.memory[b], RelaxingBody(from_.setup(), b), *step);
  }
  return tractions;
}

Field RelaxingBodies::slip() const {
  Field slip;
  const auto add_to = [](double factor, const Field& part, Field& sum) {
    if (part.empty()) return;
    sum.resize(part.size(), 0.0);
    contact::add_scaled(factor, part, sum);
  };
  std::array<operators::Tractions, 2> causes = remembered();
  for (int b = 0; b < 2; ++b) {
    if (!steps_[b] || !from_.memory[b]) continue;
    const operators::Tractions before = from_.equivalent_tractions(b);
    const auto add = [&](Field& cause, const Field& previous, const Field& traction) {
      add_to(-1.0, previous, cause);
      add_to(compliances_[b], traction, cause);
    };
    operators::Tractions& cause = causes[b];
    add(cause.pressure, before.pressure, from_.tractions.pressure);
    add(cause.shear_x, before.shear_x, from_.tractions.shear_x);
    add(cause.shear_y, before.shear_y, from_.tractions.shear_y);
    const double sign = operators::shear_sign(b);
    const auto displacement = from_.setup().cache.displacement(b);
    Field u = (*displacement)(cause, sign, operators::Axis::x);
    const Field v = (*displacement)(cause, sign, operators::Axis::y);
    u.insert(u.end(), v.begin(), v.end());
    add_to(-sign, u, slip);
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
