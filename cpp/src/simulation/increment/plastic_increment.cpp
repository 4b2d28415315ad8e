// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/plastic_increment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/simulation/increment/increment_symmetry.hpp"

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Mismatch below this fraction of its largest value so far is not resolved further.
constexpr double negligible_mismatch = 1e-2;
/// Finest relative tolerance with inclusions, far below the error due to the size of cells; also if
/// moduli differ by a large factor, where convergence is slow: the strain in a void is not unique,
/// while its surroundings hardly change any more.
constexpr double moderate_tol = 1e-4, strong_tol = 1e-3;

}  // namespace

PlasticIncrement::PlasticIncrement(const IncrementTask& task)
    : task_(task),
      tractions_(task.target.is_prescribed()
                     ? seen_from_body(task.target.tractions, task.setup().grid,
                                      task.from.placement().origin)
                     : operators::Tractions{task.from.tractions.pressure, {}, {}}),
      relaxing_(task_),
      sources_(task.setup(), task.from.travel,
               given_heat(task.setup(), task.target.heating, task.target.past, task.target.duration,
                          task.target.slip_power),
               task.from.eigenstrain, task.from.method, relaxing_.remembered()),
      slip_(task_, relaxing_),
      symmetry_(symmetry_of(task, tractions_, sources_)),
      mirror_images_(bodies_are_mirror_images(task, sources_)),
      guess_(task, symmetry_),
      zones_(task, symmetry_, guess_, tractions_, sources_, bodies_, active_),
      temperature_(task) {
  make_bodies();
  zones_.begin();
}

void PlasticIncrement::make_bodies() {
  bodies_.reserve(2);
  for (int b = mirror_images_ ? 1 : 0; b < 2; ++b) {
    if (!task_.setup().is_strained(b)) continue;
    const auto number = static_cast<std::uint8_t>(bodies_.size());
    const PlasticBody& body = bodies_.emplace_back(task_.from, b, number, mirror_images_ ? 2 : 1,
                                                   symmetry_, task_.target.heating[b]);
    if (body.tensor() == Tensor::full) active_.keep_trace();
  }
}

Field PlasticIncrement::first_guess() {
  Field guess = guess_.find(bodies_, active_);
  guess.resize(active_.size() * active_.components(), 0.0);
  return guess;
}

double PlasticIncrement::mismatch_tol() const {
  double tol = 0.0;
  for (const PlasticBody& body : bodies_) {
    const MixedCells& mixed = body.cells().mixed();
    if (mixed.is_on()) tol = std::max(tol, mixed.are_strong() ? strong_tol : moderate_tol);
  }
  return tol;
}

void PlasticIncrement::scatter(const Field& guess) {
  const std::ptrdiff_t count = active_.size();
#pragma omp parallel for schedule(static) if (30.0 * count > min_parallel_operations)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    bodies_[b].set_strain(cell, active_.strain(guess, n));
  }
}

contact::Solution PlasticIncrement::solve_contact(const Field& gap, double tol) {
  contact::Solution solution;
  if (task_.target.is_prescribed()) {
    solution.tractions = tractions_;
    const Field& pressure = tractions_.pressure;
    solution.load = task_.setup().grid.cell_area() *
                    ordered_sum(gap.size(), [&](std::size_t i) { return pressure[i]; });
    solution.motion.approach = std::numeric_limits<double>::quiet_NaN();
  } else {
    contact::ContactSettings settings;
    settings.tol = tol;
    // The contact of an iterate may be larger than that of the solution: the edge of the grid is
    // checked once, at the end.
    settings.on_border = contact::OnBorder::warn;
    settings.after_stall = task_.settings.after_stall;
    if (slip_.is_on()) {
      solution = slip_.solve(gap, tractions_.pressure, settings);
    } else {
      const auto contact =
          task_.setup().cache.contact(task_.target.heating, relaxing_.compliances());
      solution = contact.solve(gap, task_.target.drive, tractions_.pressure, settings);
    }
    ++task_.counters.contact_solves;
    task_.counters.contact_iterations += solution.iterations;
    tractions_ = solution.tractions;
  }
  for (PlasticBody& body : bodies_) body.set_tractions(tractions_);
  return solution;
}

void PlasticIncrement::warm(PlasticBody& body) {
  MixedCells& mixed = body.cells().mixed();
  if (!mixed.expand() || !temperature_.is_on(body.index())) return;
  Box box = Box::whole(task_.setup().grid);
  box.nz = mixed.box().nz;
  box = box.united(mixed.box().from_surface());
  if (box.nz == 0) return;
  mixed.warm({box, temperature_.rise(body.index(), body.tractions().pressure, box)});
}

void PlasticIncrement::return_map(const Field& guess, Field& mapped, Result& result) {
  const std::ptrdiff_t count = active_.size();
  mapped.resize(count * active_.components());
  active_.equivalent.resize(count);
  double excess = 0.0, overshoot = 0.0;
  Field yield_strains(count);
#pragma omp parallel for schedule(static) \
    reduction(max : excess, overshoot) if (400.0 * count > min_parallel_operations)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const auto [b, cell] = active_.cells[n];
    const PlasticBody& body = bodies_[b];
    if (body.cells().mixed().at(cell) != nullptr) {
      active_.put(active_.get(guess, n), mapped, n);
      continue;
    }
    const auto present = active_.get(guess, n);
    const auto r = body.cells().return_map(cell, active_.stress[n], present);
    active_.put(r.increment, mapped, n);
    active_.equivalent[n] = r.equivalent;
    excess = std::max(excess, r.excess);
    overshoot = std::max(overshoot, r.overshoot);
    const bool flows = r.equivalent > 0 || present != plasticity::Tensor{};
    yield_strains[n] = flows ? body.cells().strain_at_yield() : 0.0;
  }
  result.excess = excess;
  result.overshoot = overshoot;
  result.yield_strain_norm =
      std::sqrt(ordered_dot(yield_strains.data(), yield_strains.data(), yield_strains.size()));
  step_mixed(guess, mapped, result);
}

void PlasticIncrement::step_mixed(const Field& guess, Field& mapped, Result& result) {
  const std::ptrdiff_t count = active_.mixed.size();
  if (count == 0) return;
  active_.mixed_steps.resize(count);
  double excess = 0.0, overshoot = result.overshoot;
  // So far only the other cells have changed.
  result.plastic_change = std::sqrt(ordered_sum(mapped.size(), [&](std::size_t i) {
    return (mapped[i] - guess[i]) * (mapped[i] - guess[i]);
  }));
  Field squares(count), changes(count);
  std::vector<plasticity::Tensor> changes_of_mixed(count);
#pragma omp parallel for schedule(static) \
    reduction(max : excess, overshoot) if (400.0 * count > min_parallel_operations)
  for (std::ptrdiff_t m = 0; m < count; ++m) {
    const std::size_t n = active_.mixed[m];
    const auto [b, cell] = active_.cells[n];
    const PlasticBody& body = bodies_[b];
    plasticity::Tensors place;
    const auto r = body.cells().mixed().step(cell, active_.stress[n], active_.strain(guess, n),
                                             body.cells().before(cell, place));
    plasticity::Tensor change = r.eigenstrain;
    const plasticity::Tensor before = active_.before(n), present = active_.strain(guess, n);
    for (int c = 0; c < 6; ++c) {
      change[c] -= before[c];
      const double last = r.eigenstrain[c] - present[c];
      squares[m] += r.eigenstrain[c] * r.eigenstrain[c];
      changes[m] += last * last;
    }
    active_.put({}, mapped, n);
    changes_of_mixed[m] = change;
    active_.equivalent[n] = r.equivalent + r.inclusion_equivalent;
    active_.mixed_steps[m] = r;
    excess = std::max(excess, r.excess);
    overshoot = std::max(overshoot, r.overshoot);
  }
  result.increment_norm =
      std::sqrt(ordered_sum(mapped.size(), [&](std::size_t i) { return mapped[i] * mapped[i]; }));
  for (std::ptrdiff_t m = 0; m < count; ++m) {
    active_.put(changes_of_mixed[m], mapped, active_.mixed[m]);
  }
  result.mixed_excess = excess;
  result.overshoot = overshoot;
  const double size = ordered_sum(count, [&](std::size_t m) { return squares[m]; });
  result.mixed_change = std::sqrt(ordered_sum(count, [&](std::size_t m) { return changes[m]; }));
  const double largest = task_.from.largest_mismatch.empty() ? 0.0 : task_.from.largest_mismatch[0];
  const auto cells = static_cast<double>(count);
  largest_mismatch_ = std::max(largest, std::sqrt(size / cells));
  result.mismatch_norm =
      std::max(std::sqrt(size), negligible_mismatch * largest * std::sqrt(cells));
}

PlasticIncrement::Result PlasticIncrement::evaluate(Field& guess, double contact_tol,
                                                    Field& mapped) {
  // Without room for further growth, which would double the memory.
  const auto lengthen = [&] {
    guess.reserve(active_.size() * active_.components());
    guess.resize(active_.size() * active_.components(), 0.0);
  };
  // Zones that have grown contain further inclusions.
  lengthen();
  scatter(guess);
  gap_.assign(task_.setup().grid.surface_size(), 0.0);
  if (!task_.target.is_prescribed()) {
    sources_.separate(gap_);
    for (int b = 0; b < 2; ++b) sources_.displace(b, gap_);
  }
  Field* const slip = slip_.is_on() ? &slip_.begin_slip() : nullptr;
  for (PlasticBody& body : bodies_) {
    body.transform(active_.size() > 0);
    if (task_.target.is_prescribed()) continue;
    body.surface().add_displacement_to(gap_);
    if (slip != nullptr) body.surface().add_tangential_displacement_to(*slip);
  }
  Result result;
  result.contact = solve_contact(gap_, contact_tol);
  zones_.soften();
  for (PlasticBody& body : bodies_) warm(body);
  if (zones_.fit(result.contact.gap)) {
    result.grown = std::any_of(bodies_.begin(), bodies_.end(),
                               [](const PlasticBody& body) { return body.strained(); });
    for (PlasticBody& body : bodies_) body.transform(false);
  }
  for (PlasticBody& body : bodies_) {
    if (body.zones().empty()) continue;
    result.headroom = std::min(result.headroom, body.find_stress(active_));
  }
  lengthen();
  return_map(guess, mapped, result);
  result.grown = zones_.grow_at_rim() || result.grown;
  return result;
}

void PlasticIncrement::refine_contact(double contact_tol, Result& result) {
  result.contact = solve_contact(gap_, contact_tol);
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
    if (body.cells().mixed().at(cell) != nullptr) return;
    body.cells().flow(cell, active_.get(mapped, n), active_.equivalent[n]);
  });
  for (std::size_t m = 0; m < active_.mixed.size(); ++m) {
    const auto [own, cell] = active_.cells[active_.mixed[m]];
    const plasticity::MixedReturn& step = active_.mixed_steps[m];
    if (own != b || (step.equivalent == 0 && step.inclusion_equivalent == 0)) continue;
    body.cells().flow(cell, step.flow, step.equivalent);
    body.cells().mixed().flow(cell, step);
  }
  state.softening[i] = body.cells().softening();
  if (body.cells().mixed().is_on()) {
    const MixedCells::Flows flows = body.cells().mixed().finish();
    state.inclusions_flow[i] = flows.own;
    state.matrix_flow[i] = flows.of_matrix;
  }
  if (state.flowed[i] || body.cells().mixed().is_on()) {
    state.flow_boxes[i] = whole_boxes(body.zones().boxes(), task_.setup().grid, symmetry_);
    for (Box& box : state.flow_boxes[i]) box = box.from_surface();
    state.plastic[i] = body.finish();
  }
  if (!mirror_images_) return;
  state.softening[0] = state.softening[i];
  state.plastic[0] = state.plastic[i];
  state.flow_boxes[0] = state.flow_boxes[i];
  state.flowed[0] = state.flowed[i];
}

State PlasticIncrement::finish(const Field& mapped, const Result& result) {
  State state = task_.from;
  state.warnings.clear();
  state.joint_steps = 0;
  state.stall_warning.clear();
  state.converged = true;
  state.tractions = tractions_;
  state.heating = task_.target.heating;
  state.past = task_.target.past;
  state.slip_power = task_.target.slip_power;
  state.past_symmetry = task_.target.past_symmetry;
  state.softening = {};
  state.contact_gap.clear();
  state.load = result.contact.load;
  state.approach = result.contact.motion.approach;
  state.tilt = result.contact.motion.tilt;
  state.flowed = {};
  state.advance = {};
  state.met = {};
  state.far_effect = {};
  if (!active_.mixed.empty()) state.largest_mismatch = {largest_mismatch_};
  guess_.remember(bodies_, active_, mapped, state);
  scatter(mapped);
  active_.stress = std::vector<plasticity::Tensor>{};
  bool known = !task_.target.is_prescribed();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const bool moves = bodies_[b].surface().known().contains(bodies_[b].surface().seen());
    state.far_effect[bodies_[b].index()] = zones_.far_effect(bodies_[b]);
    finish(b, mapped, state);
    known = known && (moves || !state.plastic[bodies_[b].index()]);
  }
  slip_.remember(tractions_, state);
  relaxing_.remember(tractions_, state);
  if (known) state.contact_gap = result.contact.gap;
  return state;
}

}  // namespace samcontact::simulation
