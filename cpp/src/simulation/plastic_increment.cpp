// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/plastic_increment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

}  // namespace

void Undeformed::open(Field& gap) const {
  for (std::size_t i = 0; i < gap_.size(); ++i) gap[i] += gap_[i];
}

/// Mirror planes of the increment: those of the scene, of the target, and of what happened before.
fft::Symmetry PlasticIncrement::choose_symmetry() const {
  using fft::Symmetry;
  if (from_.method == operators::ResidualMethod::exact) return Symmetry::none;
  Symmetry symmetry = scene_.symmetry(from_.travel);
  if (target_.is_prescribed()) {
    symmetry = symmetry_of(tractions_, scene_.grid);
  }
  if (scene_.friction.sticks()) {
    symmetry = common(symmetry, symmetry_of(tangential_drive()));
    symmetry = common(symmetry, from_.shear_symmetry);
  }
  symmetry = common(symmetry, symmetry_of(target_.heating));
  symmetry = common(symmetry, target_.past_symmetry);
  for (const auto& history : from_.plastic) {
    if (history) symmetry = common(symmetry, history->symmetry());
  }
  return symmetry;
}

bool PlasticIncrement::twins() const {
  const auto& [upper, lower] = scene_.bodies;
  if (!upper.is_plastic() || upper != lower || scene_.friction.slides() || !rests()) return false;
  if (target_.heating[0] != target_.heating[1] || target_.past[0] != target_.past[1]) return false;
  // Two laws cannot be compared.
  if (settings_.softening[0] || settings_.softening[1]) return false;
  // They may be worn by different depths.
  if (!scene_.reliefs[0].worn.empty() || !scene_.reliefs[1].worn.empty()) return false;
  // Shear acts on the two in opposite directions.
  if (!target_.tractions.shear_x.empty() || !target_.tractions.shear_y.empty()) return false;
  const auto offset = from_.placement().offset;
  return offset[0] == offset[1] && same(from_.plastic[0], from_.plastic[1]);
}

PlasticIncrement::PlasticIncrement(const State& from, const Target& target, const Scans& scans,
                                   const Settings& settings, Counters& counters)
    : from_(from),
      target_(target),
      scans_(scans),
      settings_(settings),
      counters_(counters),
      scene_(from.scene()),
      tractions_(target.is_prescribed()
                     ? seen_from_body(target.tractions, scene_.grid, from.placement().origin)
                     : operators::Tractions{from.tractions.pressure, {}, {}}),
      undeformed_(target.is_prescribed() ? Field() : scene_.gap(from.travel)),
      heat_(scene_, target, from.placement().offset),
      sources_{&undeformed_, &heat_},
      symmetry_(choose_symmetry()),
      choice_(scene_.grid, symmetry_) {
  const bool one_for_both = twins();
  bodies_.reserve(2);
  for (int b = one_for_both ? 1 : 0; b < 2; ++b) {
    if (!scene_.bodies[b].is_plastic()) continue;
    const auto number = static_cast<std::uint8_t>(bodies_.size());
    const PlasticBody& body =
        bodies_.emplace_back(from, b, number, one_for_both ? 2 : 1, symmetry_, target.heating[b]);
    if (body.tensor() == Tensor::full) active_.keep_trace();
  }
  for (PlasticBody& body : bodies_) {
    if (body.has_history()) take_up_zones(body);
  }
  if (!scene_.friction.sticks() || target_.is_prescribed()) return;
  before_ = contact_before();
  carried_apart_ = before_.free_slip;
}

void PlasticIncrement::scatter(const Field& guess) {
  const std::ptrdiff_t count = active_.size();
#pragma omp parallel for schedule(static) if (30.0 * count > worth_threads)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    bodies_[b].set_strain(cell, active_.strain(guess, n));
  }
}

contact::Solution PlasticIncrement::solve_contact(const Field& gap, double tol) {
  contact::Solution solution;
  if (target_.is_prescribed()) {
    solution.tractions = tractions_;
    const Field& pressure = tractions_.pressure;
    solution.load = scene_.grid.cell_area() *
                    ordered_sum(gap.size(), [&](std::size_t i) { return pressure[i]; });
    solution.motion.approach = std::numeric_limits<double>::quiet_NaN();
  } else {
    contact::ContactSettings settings;
    settings.tol = tol;
    // An iterate may be larger than the solution: the border is checked once, at the end.
    settings.on_border = contact::OnBorder::warn;
    if (scene_.friction.sticks()) {
      solution = stick_and_slip(gap, settings);
    } else {
      const auto solver = scene_.solver(target_.heating);
      solution = solver->solve(gap, target_.drive, tractions_.pressure, settings);
    }
    ++counters_.contact_solves;
    counters_.contact_iterations += solution.iterations;
    tractions_ = solution.tractions;
  }
  for (PlasticBody& body : bodies_) body.meet(tractions_);
  return solution;
}

void PlasticIncrement::soften() {
  for (PlasticBody& body : bodies_) {
    Field& pressure = heating_pressure_[body.index()];
    if (!pressure.empty() || !settings_.softening[body.index()]) continue;
    pressure = body.tractions().pressure;
    soften(body, scene_.volume_below(pressure).united(whole_or_none(body)));
  }
}

void PlasticIncrement::soften(PlasticBody& body, const Box& box) {
  const int b = body.index();
  const auto& known = body.softening();
  const Box needed = known ? known->box.united(box) : box;
  body.soften(heat_.softening(b, settings_.softening[b], heating_pressure_[b], needed));
}

void PlasticIncrement::return_map(const Field& guess, Field& mapped, Result& result) {
  const std::ptrdiff_t count = active_.size();
  mapped.resize(count * active_.components());
  active_.equivalent.resize(count);
  double excess = 0.0, overshoot = 0.0;
  Field yield_strains(count);
#pragma omp parallel for schedule(static) \
    reduction(max : excess, overshoot) if (400.0 * count > worth_threads)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    const PlasticBody& body = bodies_[b];
    const auto present = active_.get(guess, n);
    const auto r = body.return_map(cell, active_.stress[n], present);
    active_.put(r.increment, mapped, n);
    active_.equivalent[n] = r.equivalent;
    excess = std::max(excess, r.excess);
    overshoot = std::max(overshoot, r.overshoot);
    const bool flows = r.equivalent > 0 || present != plasticity::Tensor{};
    yield_strains[n] = flows ? body.strain_at_yield() : 0.0;
  }
  result.excess = excess;
  result.overshoot = overshoot;
  result.yield_strain_norm =
      std::sqrt(ordered_dot(yield_strains.data(), yield_strains.data(), yield_strains.size()));
}

PlasticIncrement::Result PlasticIncrement::evaluate(Field& guess, double contact_tol,
                                                    Field& mapped) {
  scatter(guess);
  gap_.assign(scene_.grid.surface_size(), 0.0);
  for (const Source* source : sources_) source->open(gap_);
  before_.free_slip = carried_apart_;
  if (scene_.friction.sticks()) before_.free_slip.resize(2 * gap_.size(), 0.0);
  for (PlasticBody& body : bodies_) {
    body.transform(active_.size() > 0);
    if (target_.is_prescribed()) continue;
    body.open(gap_);
    if (scene_.friction.sticks()) body.slide(before_.free_slip);
  }
  Result result;
  result.contact = solve_contact(gap_, contact_tol);
  soften();
  if (fit_boxes(result.contact.gap)) {
    result.grown = std::any_of(bodies_.begin(), bodies_.end(),
                               [](const PlasticBody& body) { return body.strained(); });
    for (PlasticBody& body : bodies_) body.transform(false);
  }
  for (PlasticBody& body : bodies_) {
    if (body.zones().empty()) continue;
    result.headroom = std::min(result.headroom, body.find_stress(active_));
  }
  guess.resize(active_.size() * active_.components(), 0.0);
  return_map(guess, mapped, result);
  result.grown = grow_at_rim() || result.grown;
  return result;
}

void PlasticIncrement::refine_contact(double contact_tol, Result& result) {
  result.contact = solve_contact(gap_, contact_tol);
}

double PlasticIncrement::part_of_last_motion() const {
  const auto& last = from_.last_flow;
  const Travel& by = from_.advance;
  if (!last || by == Travel{} || last->symmetry != symmetry_) return 0.0;
  const int main = std::fabs(last->advance[0]) > std::fabs(last->advance[1]) ? 0 : 1;
  const double ratio = by[main] / last->advance[main];
  const bool same_way =
      std::fabs(by[1 - main] - ratio * last->advance[1 - main]) <= 1e-6 * std::fabs(by[main]);
  if (!same_way || !(ratio > 0 && ratio <= 2)) return 0.0;
  const auto near = [](double a, double b) { return std::fabs(a - b) <= 0.05 * std::fabs(b); };
  const double normal = target_.drive.normal.value;
  if (target_.is_load() && !near(normal, from_.load)) return 0.0;
  if (target_.is_approach() && !near(normal, from_.approach)) return 0.0;
  return ratio;
}

double PlasticIncrement::part_of_last_load() const {
  const auto& last = from_.last_flow;
  const bool stands = from_.advance == Travel{} && last && last->advance == Travel{};
  if (!stands || last->symmetry != symmetry_ || target_.is_prescribed()) return 0.0;
  // How soft bodies are comes from the contact before they flow.
  if (settings_.softening[0] || settings_.softening[1]) return 0.0;
  // Flow goes on alike where the contact changes little.
  if (from_.load < 2 * last->load) return 0.0;
  const double value = target_.drive.normal.value;
  const double ratio = target_.is_load() ? (value - from_.load) / last->load
                                         : (value - from_.approach) / last->approach;
  return ratio > 0 && ratio <= 2 ? ratio : 0.0;
}

bool PlasticIncrement::is_steady() const {
  const auto& reliefs = scene_.reliefs;
  const auto moves = [&](int b) { return !reliefs[b].heights.empty() && from_.advance[b] != 0; };
  return part_of_last_motion() > 0 && !moves(0) && !moves(1);
}

Field PlasticIncrement::first_guess() {
  // The same way, with steps that may be longer or shorter.
  const double ratio = std::max(part_of_last_motion(), part_of_last_load());
  if (ratio == 0) return {};
  Field guess;
  const std::size_t parts = active_.components();
  for (PlasticBody& body : bodies_) {
    const auto& flow = from_.last_flow->bodies[body.index()];
    if (flow.strain.size() != parts * flow.cells.size()) return {};
    for (std::size_t n = 0; n < flow.cells.size(); ++n) {
      const std::ptrdiff_t cell = body.zones().number(flow.cells[n]);
      if (cell < 0) continue;
      body.activate(static_cast<std::uint32_t>(cell), {}, active_);
      for (std::size_t c = 0; c < parts; ++c) guess.push_back(ratio * flow.strain[n * parts + c]);
    }
  }
  return guess;
}

void PlasticIncrement::remember_flow(State& state, const Field& mapped) const {
  state.last_flow = nullptr;
  const bool stands = from_.advance == Travel{};
  if (stands && target_.is_prescribed()) return;
  auto flow = std::make_shared<Flow>();
  flow->symmetry = symmetry_;
  flow->advance = from_.advance;
  flow->load = state.load - from_.load;
  // Prescribed tractions have none.
  const double approach = state.approach - from_.approach;
  if (std::isfinite(approach)) flow->approach = approach;
  const std::size_t parts = active_.components();
  for (std::size_t n = 0; n < active_.size(); ++n) {
    if (active_.equivalent[n] == 0) continue;
    const PlasticBody& body = bodies_[active_.cells[n].body];
    if (stands && !body.is_split()) continue;
    auto& kept = flow->bodies[body.index()];
    kept.cells.push_back(body.zones().cell(active_.cells[n].cell));
    for (std::size_t c = 0; c < parts; ++c) kept.strain.push_back(mapped[n * parts + c]);
  }
  if (flow->bodies[0].cells.empty() && flow->bodies[1].cells.empty()) return;
  state.last_flow = std::move(flow);
}

void PlasticIncrement::finish(std::size_t b, const Field& mapped, State& state) {
  PlasticBody& body = bodies_[b];
  const int i = body.index();
  const auto for_own_cells = [&](const auto& visit) {
    for (std::size_t n = 0; n < active_.size(); ++n) {
      if (active_.cells[n].body == b && active_.equivalent[n] != 0) visit(n);
    }
  };
  for_own_cells([&](std::size_t n) {
    const std::uint32_t cell = active_.cells[n].cell;
    state.flowed[i] = true;
    body.flow(cell, active_.get(mapped, n), active_.equivalent[n]);
  });
  state.softening[i] = body.softening();
  if (state.flowed[i]) {
    state.flow_boxes[i] = whole_boxes(body.zones().boxes(), scene_.grid, symmetry_);
    state.plastic[i] = body.finish();
  }
  if (body.copies() == 1) return;
  state.softening[0] = state.softening[i];
  state.plastic[0] = state.plastic[i];
  state.flow_boxes[0] = state.flow_boxes[i];
  state.flowed[0] = state.flowed[i];
}

State PlasticIncrement::finish(const Field& mapped, const Result& result) {
  State state = from_;
  state.warnings.clear();
  state.tractions = tractions_;
  state.heating = target_.heating;
  state.past = target_.past;
  state.slip_power = target_.slip_power;
  state.past_symmetry = target_.past_symmetry;
  state.softening = {};
  state.contact_gap.clear();
  state.load = result.contact.load;
  state.approach = result.contact.motion.approach;
  state.flowed = {};
  state.advance = {};
  state.met = {};
  remember_flow(state, mapped);
  scatter(mapped);
  active_.stress = {};
  bool known = !target_.is_prescribed();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const bool moves = bodies_[b].surface().contains(bodies_[b].seen_surface());
    finish(b, mapped, state);
    known = known && (moves || !state.plastic[bodies_[b].index()]);
  }
  remember_slip(state);
  if (known) state.contact_gap = result.contact.gap;
  return state;
}

}  // namespace samcontact::simulation
