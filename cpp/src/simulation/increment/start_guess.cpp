// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/start_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace samcontact::simulation {

namespace {

/// Whether zones contain a cell with an inclusion.
bool is_mixed(const PlasticBody& body, const Cell& cell) {
  const std::ptrdiff_t number = body.zones().number(cell);
  return number >= 0 && body.cells().mixed().at(static_cast<std::size_t>(number)) != nullptr;
}

/// Whether the strain of all inclusions of a body follows from its load: without plastic strain and
/// misfit.
bool is_elastic(const IncrementTask& task, const PlasticBody& body) {
  const int b = body.index();
  const State& from = task.from;
  return body.cells().mixed().is_on() && !task.setup().inclusions[b]->has_misfit() &&
         !from.inclusions_flow[b] && !from.matrix_flow[b] && body.history() &&
         body.history()->tiles().max_equivalent() == 0;
}

/// Strain of elastic inclusions in proportion to a load that decreases; empty: no estimate.
Field unloaded(const IncrementTask& task, const std::vector<PlasticBody>& bodies,
               const ActiveCells& active) {
  const double before = task.from.load, after = task.target.drive.normal.value;
  const bool decreases =
      task.target.is_load() && task.from.advance == Travel{} && after >= 0 && after < before;
  const auto elastic = [&](const PlasticBody& body) { return is_elastic(task, body); };
  if (!decreases || active.mixed.empty() || !std::ranges::all_of(bodies, elastic)) return {};
  Field guess(active.size() * active.components(), 0.0);
  for (const std::size_t n : active.mixed) {
    plasticity::Tensor change = active.before(n);
    for (double& part : change) part *= after / before - 1;
    active.put(change, guess, n);
  }
  return guess;
}

}  // namespace

double StartGuess::part_of_last_motion() const {
  const auto& last = task_.from.last_flow;
  const Travel& by = task_.from.advance;
  if (!last || by == Travel{} || last->symmetry != symmetry_) return 0.0;
  const std::array now{by.x[1], by.x[0], by.y[1], by.y[0]};
  const Travel& then = last->advance;
  const std::array before{then.x[1], then.x[0], then.y[1], then.y[0]};
  const auto shorter = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
  const auto main = std::ranges::max_element(before, shorter) - before.begin();
  const double ratio = now[main] / before[main];
  const auto turned = [&](double a, double b) {
    return std::fabs(a - ratio * b) > 1e-6 * std::fabs(now[main]);
  };
  if (!(ratio > 0 && ratio <= 2)) return 0.0;
  for (std::size_t n = 0; n < now.size(); ++n) {
    if (turned(now[n], before[n])) return 0.0;
  }
  const auto near = [](double a, double b) { return std::fabs(a - b) <= 0.05 * std::fabs(b); };
  const double normal = task_.target.drive.normal.value;
  if (task_.target.is_load() && !near(normal, task_.from.load)) return 0.0;
  if (task_.target.is_approach() && !near(normal, task_.from.approach)) return 0.0;
  return ratio;
}

double StartGuess::part_of_last_load() const {
  const auto& last = task_.from.last_flow;
  const bool stands = task_.from.advance == Travel{} && last && last->advance == Travel{};
  if (!stands || last->symmetry != symmetry_ || task_.target.is_prescribed()) return 0.0;
  // Softening follows from the contact before plastic flow.
  if (task_.settings.softening[0] || task_.settings.softening[1]) return 0.0;
  // Plastic flow continues in the same way if the contact changes little.
  if (task_.from.load < 2 * last->load) return 0.0;
  const double value = task_.target.drive.normal.value;
  const double ratio = task_.target.is_load() ? (value - task_.from.load) / last->load
                                              : (value - task_.from.approach) / last->approach;
  return ratio > 0 && ratio <= 2 ? ratio : 0.0;
}

bool StartGuess::is_steady() const {
  const auto& reliefs = task_.setup().reliefs;
  const auto moves = [&](int b) {
    return !reliefs[b].heights.empty() && task_.from.advance.moves(b);
  };
  return part_of_last_motion() > 0 && !moves(0) && !moves(1);
}

Field StartGuess::find(std::vector<PlasticBody>& bodies, ActiveCells& active) const {
  // Motion in the same direction, with increments that may be longer or shorter.
  const double ratio = std::max(part_of_last_motion(), part_of_last_load());
  if (ratio == 0) return unloaded(task_, bodies, active);
  const std::size_t parts = active.components();
  Field guess(active.size() * parts, 0.0);
  for (PlasticBody& body : bodies) {
    const auto& flow = task_.from.last_flow->bodies[body.index()];
    if (flow.strain.size() != parts * flow.cells.size()) return {};
    const int steps = static_cast<int>(std::lround(task_.from.advance.x[body.index()]));
    active.reserve(active.size() + flow.cells.size());
    guess.reserve(guess.size() + flow.strain.size());
    for (std::size_t n = 0; n < flow.cells.size(); ++n) {
      // Inclusions move with the body, the flow of the matrix stays with the contact.
      Cell moved = flow.cells[n];
      moved.i += steps;
      const bool inclusion = steps != 0 && is_mixed(body, moved);
      const std::ptrdiff_t cell = body.zones().number(inclusion ? moved : flow.cells[n]);
      if (cell < 0) continue;
      const auto number = static_cast<std::uint32_t>(cell);
      const bool mixed = body.cells().mixed().at(number) != nullptr;
      if (mixed && !inclusion && steps != 0) continue;
      if (!mixed) {
        body.activate(number, {}, active);
        guess.resize(guess.size() + parts);
      }
      const std::size_t at = mixed ? parts * body.active_number(number) : guess.size() - parts;
      for (std::size_t c = 0; c < parts; ++c) guess[at + c] = ratio * flow.strain[n * parts + c];
    }
  }
  return guess;
}

void StartGuess::remember(const std::vector<PlasticBody>& bodies, const ActiveCells& active,
                          const Field& increment, State& state) const {
  state.last_flow = nullptr;
  const bool stands = task_.from.advance == Travel{};
  if (stands && task_.target.is_prescribed()) return;
  auto flow = std::make_shared<PlasticIncrementGuess>();
  flow->symmetry = symmetry_;
  flow->advance = task_.from.advance;
  flow->load = state.load - task_.from.load;
  // Undefined for prescribed tractions.
  const double approach = state.approach - task_.from.approach;
  if (std::isfinite(approach)) flow->approach = approach;
  const std::size_t parts = active.components();
  for (std::size_t n = 0; n < active.size(); ++n) {
    const PlasticBody& body = bodies[active.cells[n].body];
    const bool mixed = body.cells().mixed().at(active.cells[n].cell) != nullptr;
    if (active.equivalent[n] == 0 && !mixed) continue;
    if (stands && !body.is_split() && !body.cells().mixed().is_on()) continue;
    // Inclusions that move by parts of cells have no cells to follow.
    const double by = task_.from.advance.x[body.index()];
    if (mixed && by != std::round(by)) continue;
    auto& kept = flow->bodies[body.index()];
    kept.cells.push_back(body.zones().cell(active.cells[n].cell));
    for (std::size_t c = 0; c < parts; ++c) kept.strain.push_back(increment[n * parts + c]);
  }
  if (flow->bodies[0].cells.empty() && flow->bodies[1].cells.empty()) return;
  state.last_flow = std::move(flow);
}

}  // namespace samcontact::simulation
