// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/simulation/fixed_point.hpp"

namespace samcontact::simulation {
namespace {

bool all_finite(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); });
}

void require_field(const Field& field, std::size_t size, const std::string& name,
                   const std::string& shape) {
  if (field.size() != size) throw std::invalid_argument(name + " must have shape " + shape);
  if (!all_finite(field)) throw std::invalid_argument(name + " must be finite everywhere");
}

std::string shape_text(std::initializer_list<int> extents) {
  std::string shape;
  for (const int n : extents) {
    shape += shape.empty() ? "(" : ", ";
    shape += std::to_string(n);
  }
  return shape + ")";
}

/// Where plastic flow of this increment meets the bottom ("bottom") or a side of the volume.
std::string flow_at_border(const Grid& grid, const PlasticState* before,
                           const PlasticState* after) {
  if (after == before) return {};
  bool bottom = false, side = false;
  for (int k = 0; k < grid.nz; ++k) {
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const bool at_side = i == 0 || j == 0 || i == grid.nx - 1 || j == grid.ny - 1;
        const bool at_bottom = k == grid.nz - 1;
        if (!at_side && !at_bottom) continue;
        const std::size_t n = (static_cast<std::size_t>(k) * grid.nx + i) * grid.ny + j;
        if (after->equivalent[n] == (before ? before->equivalent[n] : 0.0)) continue;
        bottom |= at_bottom;
        side |= at_side && !at_bottom;
      }
    }
  }
  if (bottom) return "bottom of the volume (" + to_text(grid.nz * grid.dz) + " m): enlarge nz dz";
  if (side) {
    return "sides of the volume (" + to_text(grid.nx * grid.dx) + " m x " +
           to_text(grid.ny * grid.dy) + " m): enlarge nx dx and ny dy";
  }
  return {};
}

/// Largest difference between two solutions of one increment: of the pressure relative to its
/// maximum, and of the equivalent plastic strain relative to its maximum or the strain at yield.
double increment_error(const State& one, const State& two) {
  const auto largest = [](const Field& f) { return *std::max_element(f.begin(), f.end()); };
  const auto difference = [](const Field& a, const Field& b) {
    double d = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::fabs(a[i] - b[i]));
    return d;
  };
  const double p_max = largest(two.tractions.pressure);
  double error =
      p_max > 0 ? difference(one.tractions.pressure, two.tractions.pressure) / p_max : 0.0;
  for (int b = 0; b < 2; ++b) {
    if (!one.plastic[b] || !two.plastic[b]) continue;
    const auto& material = two.scene().materials[b];
    const double yield_strain =
        material.hardening.yield_stress(0.0) / (3 * material.elastic.shear_modulus());
    const Field& g = two.plastic[b]->equivalent;
    error = std::max(
        error, difference(one.plastic[b]->equivalent, g) / std::max(largest(g), yield_strain));
  }
  return error;
}

}  // namespace

Simulation::Simulation(const Grid& grid, const plasticity::Material& body1,
                       const plasticity::Material& body2, Field initial_gap, double friction,
                       const Settings& settings)
    : scene_(
          (require_field(initial_gap, grid.surface_size(), "gap", shape_text({grid.nx, grid.ny})),
           std::make_shared<Scene>(grid, body1, body2, std::move(initial_gap), friction))),
      settings_(settings),
      state_(scene_) {
  require(settings.tol >= 1e-11 && settings.tol < 1, "tol", "in [1e-11, 1)", settings.tol);
  if (settings.increment_tol != 0) {
    // Closer to tol, the difference of two solutions is their own residual.
    require(settings.increment_tol >= 10 * settings.tol && settings.increment_tol < 1,
            "increment_tol", "in [10 tol, 1) with tol = " + to_text(settings.tol),
            settings.increment_tol);
  }
  if (grid.nz == 0 && (body1.is_plastic() || body2.is_plastic())) {
    throw std::invalid_argument(
        "nz must be > 0 for an inelastic body: give the grid layers with nz and dz");
  }
}

void Simulation::check(const Target& target) const {
  if (target.kind == Target::Kind::load) {
    require(std::isfinite(target.value) && target.value >= 0, "load", "a finite number >= 0 [N]",
            target.value);
  } else if (target.kind == Target::Kind::approach) {
    require(std::isfinite(target.value), "approach", "a finite number [m]", target.value);
  } else {
    const Grid& grid = scene_->grid;
    const std::string shape = shape_text({grid.nx, grid.ny});
    require_field(target.tractions.pressure, grid.surface_size(), "pressure", shape);
    for (const Field* shear : {&target.tractions.shear_x, &target.tractions.shear_y}) {
      if (!shear->empty()) require_field(*shear, grid.surface_size(), "shear", shape);
    }
  }
}

Target Simulation::between(const State& from, const Target& target, double fraction) const {
  Target part = target;
  if (fraction == 1.0) return part;
  const auto mix = [fraction](double a, double b) { return a + fraction * (b - a); };
  if (target.kind == Target::Kind::load) {
    part.value = mix(from.load, target.value);
  } else if (target.kind == Target::Kind::approach) {
    part.value = mix(from.approach, target.value);
  } else {
    const auto mix_field = [&](const Field& a, Field& b) {
      if (a.empty() && b.empty()) return;
      b.resize(scene_->grid.surface_size(), 0.0);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = mix(a.empty() ? 0.0 : a[i], b[i]);
    };
    mix_field(from.tractions.pressure, part.tractions.pressure);
    mix_field(from.tractions.shear_x, part.tractions.shear_x);
    mix_field(from.tractions.shear_y, part.tractions.shear_y);
  }
  return part;
}

State Simulation::advance(const Target& target) {
  const double least = std::ldexp(1.0, -settings_.max_halvings);
  State moment = state_;
  int iterations = 0, substeps = 0;
  const auto solve = [&](const State& from, double start, double end) {
    // The remaining way from the moment reached: (end - start) of (1 - start).
    const double fraction = end == 1.0 ? 1.0 : (end - start) / (1.0 - start);
    State state = solve_increment(from, between(from, target, fraction), settings_, counters_);
    iterations += state.plastic_iterations;
    return state;
  };
  double done = 0.0, part = 1.0;
  std::optional<State> known;  // the state at done + part, if it was solved before
  while (done < 1.0) {
    const double goal = std::min(1.0, done + part);
    try {
      State next = known ? std::move(*known) : solve(moment, done, goal);
      known.reset();
      bool widen = true;
      if (settings_.increment_tol > 0 && next.plastic != moment.plastic) {
        const double middle = done + 0.5 * (goal - done);
        State half = solve(moment, done, middle);
        State twice = solve(half, middle, goal);
        const double error = increment_error(next, twice);
        if (error > settings_.increment_tol) {
          part = middle - done;
          if (part < least) {
            throw std::invalid_argument("increment_tol " + to_text(settings_.increment_tol) +
                                        " asks for parts smaller than " + to_text(least) +
                                        " of the increment to " + describe(target) +
                                        ": take smaller increments or a larger tolerance");
          }
          known = std::move(half);
          continue;
        }
        widen = error < 0.25 * settings_.increment_tol;
        next = std::move(twice);
        ++substeps;
      }
      moment = std::move(next);
      done = goal;
      ++substeps;
      if (widen) part = std::min(2 * part, 1.0 - done);
    } catch (const ConvergenceError&) {
      known.reset();
      part *= 0.5;
      ++counters_.halvings;
      const bool no_start =
          target.kind == Target::Kind::approach && !std::isfinite(moment.approach);
      if (part < least || no_start) throw;
    }
  }
  moment.plastic_iterations = iterations;
  moment.substeps = substeps;
  return moment;
}

std::vector<std::string> Simulation::border_complaints(const State& reached,
                                                       const Target& target) const {
  std::vector<std::string> complaints;
  const auto add = [&](std::string what) {
    if (what.empty()) return;
    if (settings_.on_border == contact::OnBorder::error) throw contact::too_small(what);
    complaints.push_back(std::move(what));
  };
  if (target.kind != Target::Kind::tractions) {
    add(contact::border_complaint(scene_->grid, reached.tractions.pressure, describe(target)));
  }
  for (int b = 0; b < 2; ++b) {
    if (!reached.plastic[b]) continue;
    const auto where =
        flow_at_border(scene_->grid, state_.plastic[b].get(), reached.plastic[b].get());
    if (where.empty()) continue;
    add("at " + describe(target) + " the plastic zone of body " + std::to_string(b + 1) +
        " reaches the " + where);
  }
  return complaints;
}

const State& Simulation::step(const Target& target) {
  check(target);
  const long contact_before = counters_.contact_iterations;
  State reached = advance(target);
  reached.contact_iterations = static_cast<int>(counters_.contact_iterations - contact_before);
  reached.warnings = border_complaints(reached, target);
  if (target.kind == Target::Kind::tractions) {
    reached.gap = scene_->initial_gap;
    for (int b = 0; b < 2; ++b) {
      const Field u = reached.surface_displacement(b);
      for (std::size_t i = 0; i < u.size(); ++i) reached.gap[i] += u[i];
    }
  }
  state_ = std::move(reached);
  return state_;
}

void Simulation::set_plastic_state(int body, Field strain, Field equivalent) {
  const Grid& grid = scene_->grid;
  if (!scene_->materials[body].is_plastic()) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is not inelastic: it has no plastic strain to set");
  }
  require_field(strain, 6 * grid.volume_size(), "strain",
                shape_text({6, grid.nx, grid.ny, grid.nz}));
  if (equivalent.empty()) equivalent.assign(grid.volume_size(), 0.0);
  require_field(equivalent, grid.volume_size(), "equivalent",
                shape_text({grid.nx, grid.ny, grid.nz}));
  const double lowest = *std::min_element(equivalent.begin(), equivalent.end());
  require(lowest >= 0, "equivalent", ">= 0 everywhere", lowest);
  auto plastic = std::make_shared<PlasticState>();
  plastic->strain = std::move(strain);
  plastic->equivalent = std::move(equivalent);
  state_.plastic[body] = std::move(plastic);
}

void Simulation::restore(const State& state, const Counters& counters) {
  state_ = state;
  counters_ = counters;
}

std::size_t Simulation::volume_bytes() const {
  std::size_t bytes = 0;
  for (int b = 0; b < 2; ++b) {
    if (const auto& plastic = state_.plastic[b]) {
      bytes += (plastic->strain.size() + plastic->equivalent.size()) * sizeof(double);
    }
    const auto& volume = scene_->volumes[b];
    if (volume && (b == 0 || volume != scene_->volumes[0])) bytes += volume->bytes();
  }
  return bytes;
}

}  // namespace samcontact::simulation
