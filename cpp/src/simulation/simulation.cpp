// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/contact/tangential/shear_problem.hpp"
#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/cells/box_choice.hpp"
#include "samcontact/simulation/increment/division.hpp"
#include "samcontact/simulation/state/contact_fields.hpp"
#include "samcontact/simulation/state/description.hpp"

namespace samcontact::simulation {
namespace {

void require_field(const Field& field, std::size_t size, const std::string& name,
                   const std::string& shape) {
  if (field.size() != size) throw std::invalid_argument(name + " must have shape " + shape);
  if (!contact::all_finite(field)) throw std::invalid_argument(name + " must be finite everywhere");
}

std::string shape_text(std::initializer_list<int> extents) {
  std::string shape;
  for (const int n : extents) {
    shape += shape.empty() ? "(" : ", ";
    shape += std::to_string(n);
  }
  return shape + ")";
}

/// Throws std::invalid_argument unless there is one deviator for each backstress, within its limit.
/// materials: indices of the materials of the cells; empty: a single one.
void check_backstress(const plasticity::Body& body, const std::vector<std::uint16_t>& materials,
                      const Field& backstress, const Grid& grid) {
  const std::size_t cells = grid.volume_size();
  const int terms = static_cast<int>(body.backstresses());
  require_field(backstress, cells * 6 * terms, "backstress",
                shape_text({terms, 6, grid.nx, grid.ny, grid.nz}));
  const auto limit_of = [&](int term, std::size_t cell) {
    const auto& laws = body.material(materials.empty() ? 0 : materials[cell]).backstresses;
    if (term >= static_cast<int>(laws.size())) return 0.0;
    return laws[term].recovery > 0 ? laws[term].modulus / laws[term].recovery : INFINITY;
  };
  for (int t = 0; t < terms; ++t) {
    for (std::size_t n = 0; n < cells; ++n) {
      const double limit = limit_of(t, n);
      plasticity::Tensor x;
      for (int c = 0; c < 6; ++c) x[c] = backstress[(6 * t + c) * cells + n];
      const double size = plasticity::von_mises(x), trace = x[0] + x[1] + x[2];
      require(size <= limit * (1 + 1e-9), "backstress",
              "at most modulus/recovery = " + to_text(limit) + " Pa (von Mises)", size);
      const double largest = std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
      require(std::fabs(trace) <= 1e-9 * largest, "backstress", "a deviator, with trace 0 Pa",
              trace);
    }
  }
}

/// Fields of a history in a box: strain with six components, and equivalent strain and backstress
/// if given.
struct GivenHistory {
  const Box& box;
  const Field &strain, &equivalent, &backstress;
  std::size_t terms;  // number of backstresses of the body
};

PlasticRecord record_of(const GivenHistory& given, const Box& box, operators::Tensor tensor) {
  const std::size_t cells = given.box.volume_size();
  const auto cut = [&](const double* from, double* to) { extract(from, given.box, to, box); };
  const auto places = operators::components(tensor);
  PlasticRecord record{.tensor = tensor, .box = box, .zones = {box}};
  record.strain.resize(places.size() * box.volume_size());
  record.equivalent.resize(box.volume_size());
  record.backstress.resize(5 * given.terms * box.volume_size());
  for (std::size_t c = 0; c < places.size(); ++c) {
    cut(given.strain.data() + places[c] * cells, record.strain.data() + c * box.volume_size());
  }
  if (!given.equivalent.empty()) cut(given.equivalent.data(), record.equivalent.data());
  if (!given.backstress.empty()) {
    const auto five = operators::components(operators::Tensor::deviator);
    for (std::size_t c = 0; c < 5 * given.terms; ++c) {
      cut(given.backstress.data() + (c / 5 * 6 + five[c % 5]) * cells,
          record.backstress.data() + c * box.volume_size());
    }
  }
  return record;
}

/// Maximum number of solves of an increment with heat due to slip, and number of iterates used by
/// their acceleration.
constexpr int max_heat_solves = 20, heat_anderson_depth = 4;
/// Allowed relative difference between the heat and that of the slip, in units of the tolerance;
/// and power that counts as zero [W/m^2].
constexpr double power_tol_ratio = 10.0, smallest_power = 1e-200;

/// Throws std::invalid_argument unless the bodies move by whole cells along an axis.
void require_whole_cells(const std::array<double, 2>& by, const std::string& along, double size,
                         const char* condition) {
  for (int b = 0; b < 2; ++b) {
    if (std::fabs(by[b] - std::round(by[b])) > 1e-6) {
      throw std::invalid_argument("advance of body " + std::to_string(b + 1) + along +
                                  " must be a multiple of the cell size, " + to_text(size) +
                                  " m, " + condition + ", got " + to_text(by[b] * size) + " m");
    }
  }
}

/// Throws std::invalid_argument for motion along y that a part of the simulation excludes.
void require_free_to_advance_along_y(const State& state, const Travel& by) {
  const Setup& setup = state.setup();
  const bool strained = setup.is_strained(0) || setup.is_strained(1);
  const bool given = state.eigenstrain[0] || state.eigenstrain[1];
  const char* reason = "";
  if (setup.is_viscoelastic()) {
    reason = "of viscoelastic bodies, whose track is kept along x only: use elastic bodies";
  } else if (setup.inclusions[0] || setup.inclusions[1]) {
    reason = "of bodies with inclusions, whose strain moves along x only: move along x";
  } else if (!setup.reliefs[0].heights.empty() || !setup.reliefs[1].heights.empty()) {
    reason = "with relief1 or relief2, which move along x only: omit the relief";
  } else if (setup.grid.period.y > 0 && (strained || given)) {
    reason =
        "of bodies with plastic strain or an eigenstrain on a grid that is periodic along y: "
        "exchange the axes, or use an open grid";
  }
  if (*reason != '\0') {
    throw std::invalid_argument(std::string("advance along y is not supported ") + reason);
  }
  const bool sticks = setup.friction.sticks();
  if (sticks && std::fabs(by.y[0] - by.y[1]) > 1e-6) {
    throw std::invalid_argument(
        "advance of both bodies along y must be equal with partial slip, got a difference of " +
        to_text((by.y[0] - by.y[1]) * setup.grid.dy) +
        " m: prescribe a relative motion along y by shift");
  }
  if (sticks || strained || given) {
    require_whole_cells(by.y, " along y", setup.grid.dy,
                        "with partial slip, plastic strain or an eigenstrain");
  }
}

/// Friction power per area from the work per area in a time [i][j] [W/m^2].
Field power_of(const Field& work, double duration, std::size_t cells) {
  Field power(cells, 0.0);
  if (duration == 0) return power;
  for (std::size_t i = 0; i < work.size(); ++i) power[i] = std::max(work[i], 0.0) / duration;
  return power;
}

double total(const Field& power) {
  return ordered_sum(power.size(), [&](std::size_t i) { return std::fabs(power[i]); });
}

}  // namespace

Simulation::Simulation(const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, Field initial_gap,
                       const contact::FrictionLaw& friction, const Settings& settings,
                       const TransientHeating& transient_heating, Reliefs reliefs,
                       contact::SharedContactLaw contact_law, InclusionsPair inclusions)
    : setup_((contact::require_gap(initial_gap, grid, "gap"),
              std::make_shared<Setup>(grid, body1, body2, std::move(initial_gap), friction,
                                      settings.image_tol, transient_heating, settings.reach,
                                      std::move(reliefs), settings.split, std::move(contact_law),
                                      std::move(inclusions)))),
      settings_(settings),
      state_(setup_, settings.residual_stress) {
  if (!grid.has_volume() && (setup_->is_strained(0) || setup_->is_strained(1))) {
    throw std::invalid_argument(
        "dz is required for an elastic-plastic body; the number of layers is chosen automatically");
  }
  setup_->require_solvable_inclusions(settings.residual_stress);
  scans({});
  solve_start();
}

void Simulation::solve_start() {
  bool strained = false;
  for (int b = 0; b < 2; ++b) {
    const auto& inclusions = setup_->inclusions[b];
    if (!inclusions) continue;
    strained |= inclusions->has_misfit() || setup_->bodies[b].has_initial_stress();
  }
  if (!strained) return;
  Target none;
  none.tractions.pressure.assign(setup_->grid.surface_size(), 0.0);
  const State start = end_state(none);
  state_.plastic = start.plastic;
  state_.inclusions_flow = start.inclusions_flow;
  state_.matrix_flow = start.matrix_flow;
  state_.largest_mismatch = start.largest_mismatch;
  state_.flow_boxes = start.flow_boxes;
  state_.contact_gap.clear();
}

const Scans& Simulation::scans(const operators::HeatingPair& heating) {
  const auto& [upper, lower] = setup_->bodies;
  const bool equal =
      setup_->media[0] == setup_->media[1] && heating[0] == heating[1] && upper.changes_like(lower);
  for (int b = 0; b < 2; ++b) {
    if (!setup_->bodies[b].is_plastic()) continue;
    if (scans_[b] && scans_heating_[b] == heating[b]) continue;
    scans_[b] = b == 1 && scans_[0] && equal
                    ? scans_[0]
                    : std::make_shared<const YieldScan>(setup_->grid, setup_->strength(b, {}),
                                                        setup_->media[b],
                                                        setup_->cache.heat_stress(b, heating[b]));
  }
  scans_heating_ = heating;
  return scans_;
}

void Simulation::check(const Target& target) const {
  if (!target.advance.is_along_x()) require_free_to_advance_along_y(state_, target.advance);
  if (setup_->is_viscoelastic()) {
    require_whole_cells(target.advance.x, "", setup_->grid.dx, "if a body is viscoelastic");
  }
  if (setup_->transient_heating.is_on() && target.duration == 0 && state_.load != 0) {
    throw std::invalid_argument(
        "duration must be > 0 for an increment that unloads the bodies, got 0: unload them first");
  }
  if (!target.is_prescribed()) {
    return contact::require_valid(target.drive, *setup_->contact_law, setup_->grid);
  }
  if (setup_->contact_law->attracts()) {
    throw std::invalid_argument(
        "pressure cannot be prescribed for surfaces with attraction: no contact would be solved");
  }
  contact::require_surface(target.tractions.pressure, setup_->grid, "pressure");
  for (const Field* shear : {&target.tractions.shear_x, &target.tractions.shear_y}) {
    if (!shear->empty()) contact::require_surface(*shear, setup_->grid, "shear");
  }
}

std::vector<std::string> Simulation::edge_warnings(const State& reached,
                                                   const Target& target) const {
  if (target.is_prescribed()) return {};
  const Field repulsion = simulation::repulsion(reached);
  std::string what = contact::edge_warning(setup_->grid, repulsion, describe(target));
  if (what.empty()) return {};
  if (settings_.on_border == contact::OnBorder::error) {
    throw contact::too_small(setup_->grid, repulsion, what);
  }
  return {std::move(what)};
}

State Simulation::end_state(const Target& target) {
  const auto scans_of = [this](const auto& heating) -> const Scans& { return scans(heating); };
  return Division(state_, target, settings_, counters_, scans_of).walk();
}

State Simulation::heated_by_slip(Target target) {
  const Grid& grid = setup_->grid;
  const double duration = target.duration;
  // Without a history the heat of earlier increments has no effect.
  if (!setup_->has_time()) target.duration = 0.0;
  const auto moving = symmetry_of({target.heating[0].of_power(), target.heating[1].of_power()});
  Field& power = target.slip_power;
  power = state_.slip_power;
  power.resize(grid.surface_size(), 0.0);
  contact::Anderson anderson(heat_anderson_depth);
  double error = 1.0;
  for (int n = 0; n < max_heat_solves; ++n) {
    target.past_symmetry = common(moving, symmetry_of(power, grid));
    State state = end_state(target);
    Field change = power_of(state.slip_work, duration, power.size());
    const double all = total(change);
    contact::add_scaled(-1.0, power, change);
    const double changed = total(change);
    error = changed > 0 ? changed / std::max(all, smallest_power) : 0.0;
    if (error <= power_tol_ratio * settings_.tol) return state;
    anderson.next(power, change);
    for (double& q : power) q = std::max(q, 0.0);
  }
  throw ConvergenceError("coupled slip and frictional heating did not converge at " +
                             describe(target) + ": relative change " + to_short_text(error) +
                             " after " + std::to_string(max_heat_solves) +
                             " solves: use a longer duration or a smaller increment",
                         max_heat_solves, error);
}

const State& Simulation::step(const Target& target) {
  check(target);
  const long contact_before = counters_.contact_iterations;
  Target whole = target;
  const auto& [pressure, shear_x, shear_y] = target.tractions;
  if (shear_x.empty() && shear_y.empty()) whole.tractions = setup_->friction.tractions(pressure);
  const bool slip_heats = whole.heating[0].is_of_slip() || whole.heating[1].is_of_slip();
  State reached = slip_heats ? heated_by_slip(std::move(whole)) : end_state(whole);
  reached.contact_iterations = static_cast<int>(counters_.contact_iterations - contact_before);
  reached.warnings = edge_warnings(reached, target);
  state_ = std::move(reached);
  return state_;
}

void Simulation::set_plastic_state(int body, const Box& whole, const Field& strain,
                                   const Field& equivalent, const Field& backstress) {
  const Grid grid = whole.grid(setup_->grid);
  if (setup_->inclusions[body]) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " has inclusions: its plastic strain cannot be set");
  }
  if (!setup_->bodies[body].is_plastic()) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is not elastic-plastic: its plastic strain cannot be set");
  }
  const std::size_t cells = grid.volume_size();
  require_field(strain, 6 * cells, "strain", shape_text({6, grid.nx, grid.ny, grid.nz}));
  if (!equivalent.empty()) {
    require_field(equivalent, cells, "equivalent", shape_text({grid.nx, grid.ny, grid.nz}));
    const double lowest = *std::min_element(equivalent.begin(), equivalent.end());
    require(lowest >= 0, "equivalent", ">= 0 everywhere", lowest);
  }
  if (!backstress.empty()) {
    const auto materials = setup_->strength(body, state_.travel).materials(whole);
    check_backstress(setup_->bodies[body], materials, backstress, grid);
  }
  // Box of all cells with a history.
  Box box;
  double largest = 0.0, trace = 0.0;
  for (std::size_t n = 0; n < cells; ++n) {
    double size = 0.0;
    for (int c = 0; c < 6; ++c) size = std::max(size, std::fabs(strain[c * cells + n]));
    largest = std::max(largest, size);
    trace = std::max(trace, std::fabs(strain[n] + strain[cells + n] + strain[2 * cells + n]));
    bool empty = size == 0 && (equivalent.empty() || equivalent[n] == 0);
    for (std::size_t c = n; c < backstress.size(); c += cells) empty &= backstress[c] == 0;
    if (empty) continue;
    const int j = static_cast<int>(n % grid.ny), i = static_cast<int>(n / grid.ny % grid.nx);
    const int k = static_cast<int>(n / grid.ny / grid.nx);
    box = box.united({whole.i0 + i, whole.j0 + j, 1, 1, k + 1});
  }
  state_.contact_gap.clear();
  if (box.empty()) {
    state_.plastic[body] = nullptr;
    return;
  }
  // Plastic strain has no trace except for rounding.
  const auto tensor =
      trace <= 1e-12 * largest ? operators::Tensor::deviator : operators::Tensor::full;
  const std::size_t terms = setup_->bodies[body].backstresses();
  const auto record = record_of({whole, strain, equivalent, backstress, terms}, box, tensor);
  state_.plastic[body] = from_record(record, setup_->grid, terms);
  const Grid& window = setup_->grid;
  const Box inside = box.intersected({0, 0, window.nx, window.ny, box.nz});
  // An increment begins with a zone on the grid; strain outside the grid has none.
  const Box middle{window.nx / 2, window.ny / 2, 1, 1, 1};
  state_.flow_boxes[body] = {inside.empty() ? middle : inside};
}

void Simulation::add_eigenstrain(int body, const Box& box, int k0, const Field& strain) {
  const Grid& grid = setup_->grid;
  setup_->require_volume(body);
  Box down = box;
  down.nz += k0;
  const bool inside = Box::surface(grid).contains({box.i0, box.j0, box.nx, box.ny, 1}) && k0 >= 0 &&
                      box.nz > 0 && (grid.nz == 0 || down.nz <= grid.nz);
  if (!inside || box.empty() || is_unbounded(down, grid)) {
    throw std::invalid_argument("the box of an eigenstrain must lie inside the grid");
  }
  require_field(strain, 6 * box.volume_size(), "strain", shape_text({6, box.nx, box.ny, box.nz}));
  Eigenstrains sum = state_.eigenstrain;
  sum[body] = sum_of(sum[body], box, k0, strain, grid);
  require_followed(sum, *setup_, state_.travel);
  state_.eigenstrain = std::move(sum);
  state_.contact_gap.clear();
  state_.last_flow = nullptr;
}

void Simulation::restore(const State& state, const Counters& counters) {
  state_ = state;
  if (same(state_.plastic[0], state_.plastic[1])) state_.plastic[1] = state_.plastic[0];
  // A stored state holds finite numbers only, also where there is no body.
  for (std::size_t i = 0; i < state_.contact_gap.size(); ++i) {
    if (std::isinf(setup_->initial_gap[i])) state_.contact_gap[i] = setup_->initial_gap[i];
  }
  counters_ = counters;
}

std::size_t Simulation::volume_bytes() const {
  std::size_t bytes = setup_->cache.bytes();
  for (int b = 0; b < 2; ++b) {
    if (const auto& strain = state_.eigenstrain[b]) bytes += strain->tiles().bytes();
    if (const auto& plastic = state_.plastic[b]) {
      if (b == 1 && plastic == state_.plastic[0]) continue;
      bytes += plastic->tiles().bytes();
    }
    if (scans_[b] && (b == 0 || scans_[b] != scans_[0])) bytes += scans_[b]->bytes();
  }
  return bytes;
}

}  // namespace samcontact::simulation
