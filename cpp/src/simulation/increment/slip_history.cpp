// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/slip_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/lagged_displacement.hpp"
#include "samcontact/contact/slip_rate.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"
#include "samcontact/simulation/sources/given_heat.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"

namespace samcontact::simulation {
namespace {

/// Mean travel of both bodies in the increment along x and y [m].
std::array<double, 2> mean_travel(const State& state) {
  const auto& [x, y] = state.advance;
  const Grid& grid = state.setup().grid;
  return {0.5 * (x[0] + x[1]) * grid.dx, 0.5 * (y[0] + y[1]) * grid.dy};
}

/// Displacement due to a rotation about the origin, of particles at their mean position during an
/// increment, less that at the end.
std::array<double, 2> lead_of(const State& state, double rotation) {
  const auto [x, y] = mean_travel(state);
  return {contact::spin_lead * y * rotation, -contact::spin_lead * x * rotation};
}

/// If the travel of a body differs from that of the tractions by this much, its displacement is
/// transported by its own travel [cells]: below, the difference between the two is slip times a
/// strain.
constexpr double min_travel_difference = 0.5;
/// Tractions that have moved by more grid lengths cause no displacement in the grid.
constexpr double farthest = 2.0;

operators::Tractions for_each(const operators::Tractions& tractions, const auto& change) {
  return {change(tractions.pressure), change(tractions.shear_x), change(tractions.shear_y)};
}

/// Tractions at their positions on the surface of a body that has moved by some cells.
operators::Tractions taken_along(const operators::Tractions& tractions, const Grid& grid,
                                 Cells cells) {
  return for_each(tractions, [&](const Field& field) { return moved(field, grid, cells); });
}

/// Whether a part of a surface field leaves the grid when it moves by some cells.
bool is_cut(const Field& field, const Grid& grid, Cells by) {
  const auto leaves = [](int place, int cells, double period) {
    return period == 0 && (place < 0 || place >= cells);
  };
  for (std::size_t at = 0; at < field.size(); ++at) {
    if (field[at] == 0) continue;
    const int i = static_cast<int>(at / grid.ny), j = static_cast<int>(at % grid.ny);
    if (leaves(i + by.x, grid.nx, grid.period.x) || leaves(j + by.y, grid.ny, grid.period.y)) {
      return true;
    }
  }
  return false;
}

/// Grid with some additional cells on all sides, and fields on it.
class Widened {
 public:
  Widened(const Grid& grid, Cells more) : narrow_(grid), wide_(grid), more_(more) {
    wide_.nx += 2 * more.x;
    wide_.ny += 2 * more.y;
  }
  const Grid& grid() const { return wide_; }
  Field operator()(const Field& field) const {
    if (field.empty()) return field;
    Field out(wide_.surface_size(), 0.0);
    for (int i = 0; i < narrow_.nx; ++i) {
      const double* from = field.data() + static_cast<std::ptrdiff_t>(i) * narrow_.ny;
      std::copy_n(from, narrow_.ny, out.data() + first_of(i));
    }
    return out;
  }
  /// Appends the part of a wide field in the grid.
  void append_inside(const Field& wide, Field& out) const {
    for (int i = 0; i < narrow_.nx; ++i) {
      const double* from = wide.data() + first_of(i);
      out.insert(out.end(), from, from + narrow_.ny);
    }
  }

 private:
  std::ptrdiff_t first_of(int i) const {
    return static_cast<std::ptrdiff_t>(i + more_.x) * wide_.ny + more_.y;
  }

  Grid narrow_, wide_;
  Cells more_;
};

/// Tangential displacement of a body [2][i][j] due to tractions moved by its travel [cells], less
/// that due to tractions moved by `cells` without those that left the grid.
Field displaced_otherwise(const Setup& setup, int body, const operators::Tractions& tractions,
                          double body_travel, Cells cells) {
  const Grid& grid = setup.grid;
  const double max_travel = farthest * grid.nx;
  const double own = grid.period.x > 0 ? std::remainder(body_travel, grid.nx)
                                       : std::clamp(body_travel, -max_travel, max_travel);
  const int whole = static_cast<int>(std::lround(own));
  const Widened widened(grid, {grid.period.x > 0 ? 0 : std::abs(whole) + 1,
                               grid.period.y > 0 ? 0 : std::min(std::abs(cells.y), 2 * grid.ny)});
  const operators::Tractions wide = for_each(tractions, widened);
  operators::Tractions difference = seen_from_body(
      taken_along(wide, widened.grid(), {whole, cells.y}), widened.grid(), own - whole);
  const operators::Tractions kept = for_each(taken_along(tractions, grid, cells), widened);
  contact::add_scaled(-1.0, kept.pressure, difference.pressure);
  contact::add_scaled(-1.0, kept.shear_x, difference.shear_x);
  contact::add_scaled(-1.0, kept.shear_y, difference.shear_y);
  Field slid;
  for (const auto axis : {operators::Axis::x, operators::Axis::y}) {
    const Field u = operators::surface_displacement(widened.grid(), *setup.media[body], {},
                                                    difference, operators::shear_sign(body), axis);
    widened.append_inside(u, slid);
  }
  return slid;
}

/// Slip due to the difference between the travel of the bodies along x [cells] and the whole cells
/// by which the tractions move; empty: none.
Field slip_of_travel(const Setup& setup, const operators::Tractions& tractions,
                     const std::array<double, 2>& travel, Cells cells) {
  const bool cut = is_cut(tractions.pressure, setup.grid, cells);
  Field slip;
  for (int b = 0; b < 2; ++b) {
    const bool differs = std::fabs(travel[b] - cells.x) >= min_travel_difference;
    // The memory of a viscoelastic body contains its tractions at their positions on the body.
    if (setup.bodies[b].is_viscoelastic()) continue;
    if (setup.media[b]->is_rigid() || !(cut || differs)) continue;
    slip.resize(2 * setup.grid.surface_size(), 0.0);
    // Previous displacement of body 2 is not slip in the opposite direction.
    contact::add_scaled(operators::shear_sign(b),
                        displaced_otherwise(setup, b, tractions, travel[b], cells), slip);
  }
  return slip;
}

/// Cells by which the surface of the followed body moves through the grid in an increment.
Cells cells_moved(const IncrementTask& task) {
  const Travel& by = task.from.advance;
  const Placement then = task.setup().placement(advanced(task.from.travel, scaled(by, -1.0)));
  const Placement now = task.from.placement();
  const int followed = std::max(task.setup().followed(), 0);
  return {then.first[followed] - now.first[followed] -
              static_cast<int>(std::lround(now.origin - then.origin)),
          then.first_y[followed] - now.first_y[followed]};
}

/// Temperature rise of the hotter surface in each cell [K].
Field hotter_surface(const IncrementTask& task) {
  const Target& target = task.target;
  const std::array surface{0.0};
  Field rise(task.setup().grid.surface_size(), 0.0);
  const auto heat =
      given_heat(task.setup(), target.heating, target.past, target.duration, target.slip_power);
  for (const GivenHeat& body : heat) {
    if (!body.is_on()) continue;
    const Field own = body.temperature(surface, 0.0);
    for (std::size_t i = 0; i < rise.size(); ++i) rise[i] = std::max(rise[i], own[i]);
  }
  return rise;
}

/// Place, temperature, slip rate and plastic slip of the cells, as far as the friction law depends
/// on them.
contact::FrictionConditions conditions_of(const IncrementTask& task) {
  const Setup& setup = task.setup();
  contact::FrictionConditions conditions;
  if (const contact::MappedCoulomb* map = setup.friction.map()) {
    const Placement place = task.from.placement();
    const int body = map->body == 1 ? 0 : 1;
    const double moved = place.first[body] + place.offset[body];
    conditions.factor = contact::factor_on(*map, setup.grid, moved * setup.grid.dx,
                                           place.first_y[body] * setup.grid.dy);
  }
  if (const contact::ThermalCoulomb* law = setup.friction.thermal()) {
    conditions.factor = hotter_surface(task);
    for (double& value : conditions.factor) value = law->factor(value);
  }
  if (setup.friction.rates().is_on()) {
    conditions.duration = task.target.lasts;
    conditions.slip_rate = moved(task.from.slip_rate, setup.grid, cells_moved(task));
  }
  if (setup.friction.hardening() != nullptr) {
    conditions.plastic_slip = moved(task.from.plastic_slip, setup.grid, cells_moved(task));
  }
  return conditions;
}

/// State from which the shear of the increment starts, before the displacement due to plastic
/// strain.
contact::ContactHistory contact_before(const IncrementTask& task) {
  const Grid& grid = task.setup().grid;
  const Travel& by = task.from.advance;
  contact::ContactHistory before;
  before.motion = task.from.rigid_motion();
  if (by == Travel{}) {
    before.pressure = task.from.tractions.pressure;
    before.shear = shear_vectors(task.from.tractions);
    before.gap = simulation::gap(task.from);
  } else {
    // Tractions of a moved state lie at its contact, not at the new positions of their cells.
    const int followed = std::max(task.setup().followed(), 0);
    const Cells cells = cells_moved(task);
    const auto carried = taken_along(task.from.tractions, grid, cells);
    before.has_moved = true;
    before.pressure = carried.pressure;
    before.shear = shear_vectors(carried);
    // Fractions of a cell move the grid, not the surface of the body that it follows.
    const double own = task.setup().followed() < 0 ? 0.5 * (by.x[0] + by.x[1]) : by.x[followed];
    const std::array travel{by.x[0] - own + cells.x, by.x[1] - own + cells.x};
    before.free_slip = slip_of_travel(task.setup(), task.from.tractions, travel, cells);
  }
  before.shear.resize(2 * grid.surface_size(), 0.0);
  return before;
}

}  // namespace

contact::TangentialDrive tangential_drive(const IncrementTask& task) {
  contact::TangentialDrive drive = task.target.tangential;
  if (!drive[0].is_force()) {
    drive[0].value += (task.from.advance.x[0] - task.from.advance.x[1]) * task.setup().grid.dx;
  }
  // Slip due to rotation is evaluated at the mean positions of particles during the increment.
  const auto lead = lead_of(task.from, drive[2].value);
  for (int axis = 0; axis < 2; ++axis) {
    if (!drive[axis].is_force()) drive[axis].value += lead[axis];
  }
  return drive;
}

bool is_free_of_shear(const IncrementTask& task) {
  if (!task.setup().friction.sticks()) return true;
  const auto drive = tangential_drive(task);
  const auto is_zero = [](double v) { return v == 0; };
  return !task.setup().partial_slip->is_coupled() &&
         std::all_of(drive.begin(), drive.end(),
                     [](const contact::Given& given) { return given.value == 0; }) &&
         std::all_of(task.from.tractions.shear_x.begin(), task.from.tractions.shear_x.end(),
                     is_zero) &&
         std::all_of(task.from.tractions.shear_y.begin(), task.from.tractions.shear_y.end(),
                     is_zero);
}

SlipHistory::SlipHistory(const IncrementTask& task, const RelaxingBodies& relaxing)
    : task_(task), on_(task.setup().friction.sticks() && !task.target.is_prescribed()) {
  if (!on_) return;
  contact_ = task.setup().slipping(relaxing.compliances());
  before_ = contact_before(task);
  conditions_ = conditions_of(task);
  plastic_slip_ = conditions_.plastic_slip;  // kept by an increment without shear
  travel_slip_ = before_.free_slip;
  const Field of_memory =
      relaxing.slip(task.from.advance == Travel{}
                        ? task.from.tractions
                        : taken_along(task.from.tractions, task.setup().grid, cells_moved(task)));
  if (of_memory.empty()) return;
  travel_slip_.resize(of_memory.size(), 0.0);
  contact::add_scaled(1.0, of_memory, travel_slip_);
}

Field& SlipHistory::begin_slip() {
  before_.free_slip = travel_slip_;
  before_.free_slip.resize(2 * task_.setup().grid.surface_size(), 0.0);
  return before_.free_slip;
}

contact::Solution SlipHistory::solve(const Field& gap, const Field& start,
                                     const contact::ContactSettings& settings) {
  const contact::Drive& drive = task_.target.drive;
  const auto& heating = task_.target.heating;
  if (!heating[0].is_on() && !heating[1].is_on()) return solve_cold(gap, start, settings);
  const contact::LaggedContact contact{
      [&](const Field& pressure, Field& separation) {
        std::fill(separation.begin(), separation.end(), 0.0);
        for (int b = 0; b < 2; ++b) {
          if (!heating[b].is_on()) continue;
          const auto heat = task_.setup().cache.flux_heat(b, heating[b]);
          contact::add_scaled(1.0, heat->displacement(pressure), separation);
        }
      },
      [&](const Field& lagged, const Field& pressure, double tol) {
        contact::ContactSettings inner = settings;
        inner.tol = tol;
        return solve_cold(lagged, pressure, inner);
      }};
  contact::Solution solution =
      contact::solve_lagged(contact, task_.setup().grid, gap, drive, start, settings.tol);
  if (!solution.converged && stall_warning_.empty()) {
    throw ConvergenceError("partial slip with heat did not converge at " + describe(drive) +
                               ": error " + to_short_text(solution.error) + " after " +
                               std::to_string(solution.iterations) + " iterations, tol " +
                               to_text(settings.tol) + ": reduce the load or heat",
                           solution.iterations, solution.error);
  }
  return solution;
}

contact::Solution SlipHistory::solve_cold(const Field& gap, const Field& start,
                                          const contact::ContactSettings& settings) {
  const contact::PartialSlipStart first{start, shear_.shear, shear_.sticking, shear_.motion,
                                        jointly_};
  contact::PartialSlipSolution found = contact_->solve(
      gap, task_.target.drive, tangential_drive(task_), before_, first, settings, conditions_);
  shear_ = std::move(found.tangential);
  stall_warning_ = std::move(found.stall_warning);
  slip_rate_ = std::move(found.slip_rate);
  plastic_slip_ = std::move(found.plastic_slip);
  falling_number_ = found.falling_number;
  jointly_ = found.joint.steps > 0;
  joint_steps_ += found.joint.steps;
  task_.counters.joint_steps += found.joint.steps;
  contact::Solution solution = std::move(found.normal);
  solution.iterations += shear_.iterations;
  const auto middle = shear_.shear.begin() + static_cast<std::ptrdiff_t>(gap.size());
  solution.tractions.shear_x.assign(shear_.shear.begin(), middle);
  solution.tractions.shear_y.assign(middle, shear_.shear.end());
  return solution;
}

void SlipHistory::remember(const operators::Tractions& tractions, State& state) const {
  if (!task_.setup().friction.sticks()) return;
  state.slip_work.clear();
  if (task_.target.is_prescribed()) {
    state.slip.clear();
    state.shear_symmetry = common(state.shear_symmetry, symmetry_of(tractions, task_.setup().grid));
    return;
  }
  state.slip = shear_.slip;
  state.slip_rate = slip_rate_;
  state.plastic_slip = plastic_slip_;
  state.falling_number = falling_number_;
  state.joint_steps = joint_steps_;
  state.stall_warning = stall_warning_;
  state.converged = stall_warning_.empty();
  if (!task_.target.slip_power.empty()) {
    const std::size_t n = task_.setup().grid.surface_size();
    const Field &s = shear_.shear, &w = shear_.slip;
    for (std::size_t i = 0; i < n; ++i) {
      state.slip_work.push_back(s[i] * w[i] + s[n + i] * w[n + i]);
    }
  }
  const auto& motion = shear_.motion;
  const auto lead = lead_of(task_.from, motion[2]);
  state.motion[0] += motion[0] - lead[0];
  state.motion[1] += motion[1] - lead[1];
  state.motion[2] += motion[2];
  state.friction_work += shear_.friction_work;
  state.shear_symmetry = common(state.shear_symmetry, symmetry_of(tangential_drive(task_)));
}

}  // namespace samcontact::simulation
