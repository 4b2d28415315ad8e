// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/division.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"
#include "samcontact/simulation/increment/fixed_point.hpp"

namespace samcontact::simulation {
namespace {

/// Largest difference between two solutions of one increment: of the pressure relative to its
/// maximum, and of the equivalent plastic strain relative to its maximum or the strain at yield.
double increment_error(const State& one, const State& two) {
  const auto largest = [](const Field& f) { return *std::max_element(f.begin(), f.end()); };
  const auto difference = [](const Field& a, const Field& b) {
    double d = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::fabs(a[i] - b[i]));
    return d;
  };
  const Grid& grid = two.setup().grid;
  const double p_max = largest(two.tractions.pressure);
  double error =
      p_max > 0 ? difference(one.tractions.pressure, two.tractions.pressure) / p_max : 0.0;
  for (int b = 0; b < 2; ++b) {
    if (!one.plastic[b] || !two.plastic[b]) continue;
    const double yield_strain = two.setup().bodies[b].strain_at_yield();
    const Box box = around(one.flow_boxes[b]).united(around(two.flow_boxes[b]));
    const auto symmetry = common(one.plastic[b]->symmetry(), two.plastic[b]->symmetry());
    const auto first = unfolded(one.plastic[b], grid, symmetry);
    const auto second = unfolded(two.plastic[b], grid, symmetry);
    const Zones zones = covering(first->zones(), second->zones(), part_of(box, grid, symmetry));
    if (zones.empty()) continue;
    const Field g = second->equivalent(zones);
    error = std::max(error,
                     difference(first->equivalent(zones), g) / std::max(largest(g), yield_strain));
  }
  return error;
}

/// Difference between solutions in one and in two parts that is allowed for an error `tol` of the
/// extrapolated result: that error is of second order while the difference is of first, and was
/// found to be up to 1100 times its square (largest pressure and plastic strain, point by point;
/// two balls to 8 GPa, 3 to 20 cells per radius).
double allowed_difference(double tol) { return 0.03 * std::sqrt(tol); }

/// Second-order result from two solutions of first order, of an increment in one and in two parts
/// (Richardson): plastic strain 2 twice - once. In cells with plastic flow in only one of them,
/// `twice`. start: with the bodies at their final positions.
State extrapolated(const State& start, const State& once, const State& twice) {
  State state = twice;
  for (int b = 0; b < 2; ++b) {
    const bool shared =
        b == 1 && once.plastic[0] == once.plastic[1] && twice.plastic[0] == twice.plastic[1];
    if (shared) state.plastic[1] = state.plastic[0], state.met[1] = state.met[0];
    if (shared || !once.flowed[b] || !twice.flowed[b]) continue;
    // The strain of inclusions follows from their stress.
    if (start.setup().inclusions[b]) continue;
    const Grid& grid = start.setup().grid;
    const PlasticState& last = *twice.plastic[b];
    const Box whole = around(once.flow_boxes[b]).united(around(twice.flow_boxes[b]));
    const Box box = part_of(whole, grid, last.symmetry());
    const auto single = unfolded(once.plastic[b], grid, last.symmetry());
    PlasticFields two = last.fields(covering(last.zones(), single->zones(), box));
    const PlasticFields one = single->fields(two.zones);
    const std::size_t cells = two.zones.cells();
    Field before(cells, 0.0);
    if (const auto earlier = unfolded(start.plastic[b], grid, last.symmetry())) {
      before = earlier->equivalent(two.zones);
    }
    for (std::size_t i = 0; i < cells; ++i) {
      const double correction = two.equivalent[i] - one.equivalent[i];
      if (std::fabs(correction) > 0.5 * (two.equivalent[i] - before[i])) continue;
      two.equivalent[i] += correction;
      for (std::size_t n = i; n < two.strain.size(); n += cells) {
        two.strain[n] += two.strain[n] - one.strain[n];
      }
      for (std::size_t n = i; n < two.backstress.size(); n += cells) {
        two.backstress[n] += two.backstress[n] - one.backstress[n];
      }
    }
    state.met[b] = twice.plastic[b];
    state.plastic[b] =
        std::make_shared<const PlasticState>(&last, last.symmetry(), last.tensor(), two, box);
  }
  return state;
}

/// Target for a fraction of an increment from a state.
Target between(const State& from, const Target& target, double fraction) {
  Target part = target;
  if (fraction == 1.0) return part;
  const auto mix = [fraction](double a, double b) { return a + fraction * (b - a); };
  if (from.setup().friction.sticks() && !target.is_prescribed()) {
    const auto present = from.tangential_force();
    for (int k = 0; k < 3; ++k) {
      double& value = part.tangential[k].value;
      value = part.tangential[k].is_force() ? mix(present[k], value) : fraction * value;
    }
  }
  double& normal = part.drive.normal.value;
  const contact::AboutAxes moment = from.moment();
  for (int k = 0; k < 2 && !target.is_prescribed(); ++k) {
    contact::Given& tilt = part.drive.tilt[k];
    tilt.value = mix(tilt.is_force() ? moment[k] : from.tilt[k], tilt.value);
  }
  if (target.is_load()) {
    normal = mix(from.load, normal);
  } else if (target.is_approach()) {
    normal = mix(from.approach + part.drive.spring * from.load, normal);
  } else {
    const auto mix_field = [&](const Field& a, Field& b) {
      if (a.empty() && b.empty()) return;
      b.resize(from.setup().grid.surface_size(), 0.0);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = mix(a.empty() ? 0.0 : a[i], b[i]);
    };
    mix_field(from.tractions.pressure, part.tractions.pressure);
    mix_field(from.tractions.shear_x, part.tractions.shear_x);
    mix_field(from.tractions.shear_y, part.tractions.shear_y);
  }
  return part;
}

/// Adds plastic flow and slip of an earlier sub-increment.
void add_part(const State& earlier, State& state) {
  for (int b = 0; b < 2; ++b) state.flowed[b] |= earlier.flowed[b];
  state.joint_steps += earlier.joint_steps;
  if (state.stall_warning.empty()) state.stall_warning = earlier.stall_warning;
  state.converged = state.stall_warning.empty();
  if (!earlier.slip_work.empty()) {
    state.slip_work.resize(earlier.slip_work.size(), 0.0);
    contact::add_scaled(1.0, earlier.slip_work, state.slip_work);
  }
  if (earlier.slip.empty()) return;
  state.slip.resize(earlier.slip.size(), 0.0);
  contact::add_scaled(1.0, earlier.slip, state.slip);
}

/// Maximum number of sub-increments that the tolerance may require: each is solved three or four
/// times.
constexpr int max_parts = 64;

}  // namespace

Division::Division(const State& from, const Target& target, Settings settings, Counters& counters,
                   ScansOf scans)
    : from_(from),
      target_(target),
      settings_(std::move(settings)),
      counters_(counters),
      scans_(std::move(scans)),
      moment_(from) {
  restart();
}

void Division::restart() {
  moment_ = from_;
  moment_.flowed = {};
  moment_.slip.clear();
  moment_.slip_work.clear();
  moment_.joint_steps = 0;
  moment_.stall_warning.clear();
  done_ = 0.0;
  stalled_ = false;
  iterations_ = substeps_ = short_parts_ = 0;
}

Target Division::part_of(const State& from, double start, double end) const {
  // The remaining part of the increment from the present state: (end - start) of (1 - start).
  Target part = between(from, target_, end == 1.0 ? 1.0 : (end - start) / (1.0 - start));
  // Prescribed motions are given for the whole increment, not for its remainder.
  for (auto& given : part.tangential) {
    if (!given.is_force()) given.value *= 1.0 - start;
  }
  part.lasts *= end - start;
  if (from.setup().has_time()) part.duration *= end - start;
  if (!from.setup().transient_heating.is_on()) return part;
  const Travel by = scaled(target_.advance, end - start);
  part.past = from.heat_so_far(by);
  for (int b = 0; b < 2; ++b) {
    operators::Heating& heat = part.heating[b];
    heat.age = part.duration;
    if (part.duration == 0) heat.age = from.setup().transient_heating.shortest;  // without flux
    if (!from.setup().transient_heating.follows()) continue;
    const bool loaded = !target_.is_load() || target_.drive.normal.value != 0;
    heat.speed_x = loaded ? by.x[b] * from.setup().grid.dx / part.duration : 0.0;
    heat.speed_y = loaded ? by.y[b] * from.setup().grid.dy / part.duration : 0.0;
  }
  part.past_symmetry = common(part.past_symmetry, from.heat_symmetry_so_far());
  if (from.setup().transient_heating.follows() && by != Travel{}) {
    part.past_symmetry =
        common(part.past_symmetry, by.is_along_x() ? fft::Symmetry::y : fft::Symmetry::none);
  }
  return part;
}

Travel Division::travel_at(double end) const {
  return advanced(from_.travel, scaled(target_.advance, end));
}

State Division::moved_to(const State& from, double end) const {
  const Travel to = travel_at(end);
  return from.travel == to ? from : from.moved(to);
}

State Division::increment(const State& from, const Target& part) {
  State state = solve_increment({from, part, scans_(part.heating), settings_, counters_});
  if (from.setup().transient_heating.is_on()) state.duration = part.duration;
  iterations_ += state.plastic_iterations;
  return state;
}

State Division::solve(const State& from, double start, double end) {
  const Target part = part_of(from, start, end);
  const Travel to = travel_at(end);
  // The fields of a body at rest are not copied.
  State state = from.travel == to ? increment(from, part) : increment(from.moved(to), part);
  const bool passes = from.setup().has_time() && std::isfinite(part.duration);
  if (passes) state.time = from.time + part.duration;
  return state;
}

std::optional<State> Division::extrapolate(const State& once, double end, double& factor) {
  const double middle = done_ + 0.5 * (end - done_);
  const State half = solve(moment_, done_, middle);
  State twice = solve(half, middle, end);
  add_part(half, twice);
  const double allowed = allowed_difference(settings_.increment_tol);
  const double error = increment_error(once, twice);
  // The difference is of second order in the length of the sub-increment.
  factor = std::clamp(0.9 * std::sqrt(allowed / std::max(error, 1e-300)), 0.2, 4.0);
  if (error > allowed) return std::nullopt;
  // Stress above the yield stress after the extrapolation causes further plastic flow.
  const State sum = extrapolated(moved_to(moment_, end), once, twice);
  Target rest = part_of(moment_, done_, end);
  if (!from_.setup().transient_heating.is_on()) rest.duration = 0.0;  // passed already
  for (auto& given : rest.tangential) {
    if (!given.is_force()) given.value = 0.0;
  }
  State state = increment(sum, rest);
  add_part(twice, state);
  return state;
}

std::optional<State> Division::next_part(double end, double& factor) {
  State once = solve(moment_, done_, end);
  factor = 2.0;
  if (settings_.increment_tol == 0 || !(once.flowed[0] || once.flowed[1])) return once;
  return extrapolate(once, end, factor);
}

void Division::refuse(const std::string& parts) const {
  // The length of sub-increments is proportional to the fourth root of the tolerance.
  const double enough = settings_.increment_tol / std::pow(done_, 4);
  const bool known = short_parts_ >= max_parts && enough < 1.0;
  throw std::invalid_argument("increment_tol = " + to_text(settings_.increment_tol) +
                              " would require " + parts + " of the increment to " +
                              describe(target_) + ": use smaller increments, or increment_tol " +
                              (known ? ">= " + to_short_text(enough) : "larger than this"));
}

State Division::walk() {
  using contact::AfterStall;
  settings_.after_stall = from_.joint_steps > 0 ? AfterStall::join : AfterStall::fail;
  const AfterStall last = settings_.accepts_stall ? AfterStall::accept : AfterStall::join;
  while (settings_.after_stall != last) {
    try {
      return walk_parts();
    } catch (const ConvergenceError&) {
      if (!stalled_) throw;
    }
    restart();
    settings_.after_stall =
        settings_.after_stall == AfterStall::fail ? AfterStall::join : AfterStall::accept;
  }
  return walk_parts();
}

State Division::walk_parts() {
  const double least = std::ldexp(1.0, -settings_.max_halvings);
  double length = 1.0, factor = 2.0;
  while (done_ < 1.0) {
    const double goal = std::min(1.0, done_ + length);
    try {
      std::optional<State> next = next_part(goal, factor);
      if (!next) {
        length = factor * (goal - done_);
        if (length < least) refuse("sub-increments smaller than " + to_text(least));
        continue;
      }
      add_part(moment_, *next);
      moment_ = std::move(*next);
      ++substeps_;
      length = std::min(factor * (goal - done_), 1.0 - goal);
      done_ = goal;
      if (factor < 2.0) ++short_parts_;  // limited by the tolerance, not by convergence
      if (short_parts_ >= max_parts && done_ < 1.0)
        refuse("more than " + std::to_string(max_parts) + " sub-increments");
    } catch (const ConvergenceError& error) {
      stalled_ = stalled_ || dynamic_cast<const StalledError*>(&error) != nullptr;
      length = 0.5 * (goal - done_);
      ++counters_.halvings;
      const bool no_start = target_.is_approach() && !std::isfinite(moment_.approach);
      if (length < least || no_start) throw;
    }
  }
  moment_.plastic_iterations = iterations_;
  moment_.substeps = substeps_;
  return std::move(moment_);
}

}  // namespace samcontact::simulation
