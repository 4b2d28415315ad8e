// SPDX-License-Identifier: GPL-3.0-or-later
// Named parts of a state that later increments and its fields depend on, described in one place for
// checkpoints and bindings.
#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "samcontact/simulation/state/counters.hpp"
#include "samcontact/simulation/state/state.hpp"

namespace samcontact::simulation {

/// Plastic history as plain fields over its zones.
struct PlasticRecord {
  fft::Symmetry symmetry{};
  operators::Tensor tensor{};
  std::array<int, 2> origin{};
  Box box;
  std::vector<Box> zones;
  Field strain{}, equivalent{}, backstress{};
};

PlasticRecord record(const PlasticState& history);
/// Plastic history of a record, for a body with the given number of backstresses. Throws
/// std::invalid_argument for a record that does not match the grid.
std::shared_ptr<const PlasticState> from_record(const PlasticRecord& record, const Grid& grid,
                                                std::size_t backstresses);

/// Throws std::invalid_argument unless the parts of a state match each other and its grid and
/// bodies.
void require_consistent(const State& state);

template <class Part, class Of>
concept Is = std::same_as<std::remove_const_t<Part>, Of>;

// `visit` is called with the name and a reference of each part: a number, an array of numbers, an
// enumeration, a field, or a described object. visit.maybe_nan is its counterpart for a number that
// may be NaN. visit.made has an immutable part, or null, with the functions that convert it to a
// plain part and back.

template <Is<Counters> C, class Visitor>
void describe(C& c, Visitor& visit) {
  visit("contact_solves", c.contact_solves);
  visit("contact_iterations", c.contact_iterations);
  visit("yield_checks", c.yield_checks);
  visit("plastic_solves", c.plastic_solves);
  visit("plastic_iterations", c.plastic_iterations);
  visit("halvings", c.halvings);
  visit("joint_steps", c.joint_steps);
}

template <Is<PlasticRecord> R, class Visitor>
void describe(R& r, Visitor& visit) {
  visit("origin", r.origin);
  visit("box", r.box);
  visit("zones", r.zones);
  visit("mirrored", r.symmetry);
  visit("tensor", r.tensor);
  visit("strain", r.strain);
  visit("equivalent", r.equivalent);
  visit("backstress", r.backstress);
}

template <Is<BoxField> F, class Visitor>
void describe(F& f, Visitor& visit) {
  visit("box", f.box);
  visit("values", f.values);
}

template <Is<TractionMemory> M, class Visitor>
void describe(M& m, Visitor& visit) {
  visit("box", m.box);
  visit("kinds", m.kinds);
  visit("values", m.values);
  visit("supplied", m.supplied);
}

template <Is<PlasticIncrementGuess> F, class Visitor>
void describe(F& f, Visitor& visit) {
  visit("mirrored", f.symmetry);
  visit("advance", f.advance.x);
  visit("load", f.load);
  visit("approach", f.approach);
  for (int b = 0; b < 2; ++b) {
    const std::string number = std::to_string(b + 1);
    visit("cells" + number, f.bodies[b].cells);
    visit("strain" + number, f.bodies[b].strain);
  }
}

template <Is<FarEffect> E, class Visitor>
void describe(E& e, Visitor& visit) {
  visit("first", e.first);
  visit("increments", e.increments);
  visit("box", e.box);
  visit("surface", e.surface);
  visit("stress", e.stress);
  visit("displacement", e.displacement);
}

constexpr auto as_it_is = [](const auto& part) -> const auto& { return part; };
constexpr auto copy_of = [](const auto& part) {
  return std::make_shared<const std::decay_t<decltype(part)>>(part);
};

/// Parts of a state that belong to body b.
template <Is<State> S, class Visitor>
void describe_body(S& s, int b, Visitor& visit) {
  const std::string number = std::to_string(b + 1);
  visit("heat_factor" + number, s.heating[b].factor);
  visit("heat_speed" + number, s.heating[b].speed_x);
  visit("lateral_heat_speed" + number, s.heating[b].speed_y);
  visit("flow_boxes" + number, s.flow_boxes[b]);
  visit.made("softening" + number, s.softening[b], as_it_is, copy_of);
  visit.made("history" + number, s.plastic[b], record, [&](const PlasticRecord& plain) {
    return from_record(plain, s.setup().grid, s.setup().bodies[b].backstresses());
  });
  visit.made("inclusions_flow" + number, s.inclusions_flow[b], record,
             [&](const PlasticRecord& plain) { return from_record(plain, s.setup().grid, 0); });
  visit.made("matrix_flow" + number, s.matrix_flow[b], record,
             [&](const PlasticRecord& plain) { return from_record(plain, s.setup().grid, 0); });
  visit.made("eigenstrain" + number, s.eigenstrain[b], record,
             [&](const PlasticRecord& plain) { return from_record(plain, s.setup().grid, 0); });
  visit.made("far_effect" + number, s.far_effect[b], as_it_is, copy_of);
  visit.made("traction_memory" + number, s.memory[b], as_it_is, copy_of);
  visit.made(
      "past" + number, s.past[b], [](const operators::HeatHistory& heat) { return heat.state(); },
      [&](const std::vector<double>& numbers) {
        auto heat = s.setup().heat_history(b, s.heating[b]);
        heat.set_state(numbers);
        return std::make_shared<const operators::HeatHistory>(std::move(heat));
      });
}

template <Is<State> S, class Visitor>
void describe(S& s, Visitor& visit) {
  visit("pressure", s.tractions.pressure);
  visit("shear_x", s.tractions.shear_x);
  visit("shear_y", s.tractions.shear_y);
  visit("contact_gap", s.contact_gap);
  visit("load", s.load);
  visit.maybe_nan("approach", s.approach);
  visit("tilt", s.tilt);
  visit("slip", s.slip);
  visit("slip_rate", s.slip_rate);
  visit("plastic_slip", s.plastic_slip);
  visit("falling_number", s.falling_number);
  visit("motion", s.motion);
  visit("friction_work", s.friction_work);
  visit("slip_power", s.slip_power);
  visit("shear_symmetry", s.shear_symmetry);
  visit("travel", s.travel.x);
  visit("lateral_travel", s.travel.y);
  visit("time", s.time);
  visit("duration", s.duration);
  visit("residual_method", s.method);
  visit("iterations", s.plastic_iterations);
  visit("contact_iterations", s.contact_iterations);
  visit("substeps", s.substeps);
  visit("joint_steps", s.joint_steps);
  visit("converged", s.converged);
  visit("plastic_residual", s.plastic_residual);
  visit("yield_excess", s.yield_excess);
  visit("past_symmetry", s.past_symmetry);
  for (int b = 0; b < 2; ++b) describe_body(s, b, visit);
  visit("largest_mismatch", s.largest_mismatch);
  visit.made("last_flow", s.last_flow, as_it_is, copy_of);
}

}  // namespace samcontact::simulation
