// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/shear_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "samcontact/base/memory.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/coarsening.hpp"
#include "samcontact/contact/normal/window.hpp"
#include "samcontact/contact/tangential/partial_slip.hpp"
#include "samcontact/contact/tangential/steady_rolling.hpp"

namespace samcontact::contact {
namespace {

/// Boxes are halved while their shorter side keeps this number of cells.
constexpr int coarsest_shear_side = 16;
/// Finer cells change the set of slipping cells: the change of shear decreases with the cell size.
double coarse_shear_tol(const Grid& box) { return std::min(1e-3, 0.06 / std::max(box.nx, box.ny)); }
constexpr int coarse_steps = 30;
constexpr double partial_slip_bytes = 700, rolling_bytes = 1100;  // per cell of the box, measured

/// Fields over all cells of a box, and vectors [2][i][j] there.
struct BoxTask {
  Field pressure, free_slip;
  Field slip_part;  // three components; empty: none
  double x0, y0;    // of the first cell
  bool rolls;
  Field factor;  // of the bounds; empty: 1
};

struct BoxStart {
  Field shear;  // empty: none
  std::vector<unsigned char> slipping;
  std::vector<double> motion;
};

/// Applies a change to each component of a vector field, or of a field of symmetric matrices.
template <class Change>
Field by_component(const Field& field, const Change& change, int components = 2) {
  const auto n = static_cast<std::ptrdiff_t>(field.size()) / components;
  Field changed;
  for (int c = 0; c < components; ++c) {
    const Field part = change(Field(field.begin() + c * n, field.begin() + (c + 1) * n));
    changed.insert(changed.end(), part.begin(), part.end());
  }
  return changed;
}

}  // namespace

/// Operators of one box size, with some additional rows of cells ahead.
class ShearSolver::Level {
 public:
  Level(const Grid& box, int margin, const operators::TangentialInfluence& influence)
      : box_(box), margin_(margin), operators_(with_margin(box, margin), influence) {
    if (std::min(box.nx, box.ny) >= 2 * coarsest_shear_side && box.can_be_coarsened()) {
      coarser_ = std::make_unique<Level>(coarsened(box), margin, influence);
    }
    floats_ = margin == 0 && gives_way_to_uniform_shear(box, operators_.displacement);
  }

  const Grid& box() const { return box_; }
  int margin() const { return margin_; }
  const ShearOperators& operators() const { return operators_; }

  struct Answer {
    ShearResult result;
    std::vector<std::size_t> cells;
    int applications = 0;
    double operations = 0.0;
  };
  Answer solve(const BoxTask& task, const FrictionLaw& friction, const TangentialDrive& drive,
               BoxStart start, double tol, int max_steps) const;

 private:
  static Grid with_margin(Grid box, int margin) {
    box.nx += margin;
    return box;
  }
  std::size_t operator_size() const { return with_margin(box_, margin_).surface_size(); }
  ShearProblem problem_of(const BoxTask& task, const FrictionLaw& friction,
                          const TangentialDrive& drive) const;
  /// Changes the problem to rolling by one cell.
  void let_roll(ShearProblem& problem) const;
  double stiffness_of(const Field& pressure) const;
  BoxStart coarse_start(const BoxTask& task, const FrictionLaw& friction,
                        const TangentialDrive& drive, double tol, double& operations) const;

  Grid box_;
  int margin_;
  ShearOperators operators_;
  std::unique_ptr<Level> coarser_;
  bool floats_;  // if the whole box is in contact
};

/// Scale of the slip due to a shear proportional to the pressure, from the coarsest box.
double ShearSolver::Level::stiffness_of(const Field& pressure) const {
  if (coarser_) return coarser_->stiffness_of(coarsened(box_, pressure));
  const double max_pressure = *std::max_element(pressure.begin(), pressure.end());
  Field shear = pressure, displacement(2 * operator_size());
  for (double& s : shear) s /= max_pressure;
  shear.resize(displacement.size(), 0.0);
  ComplexField work;
  operators_.displacement.apply(shear.data(), displacement.data(), work);
  return 1 / longest(displacement);
}

ShearProblem ShearSolver::Level::problem_of(const BoxTask& task, const FrictionLaw& friction,
                                            const TangentialDrive& drive) const {
  ShearProblem problem;
  problem.operators = &operators_;
  problem.box_size = operator_size();
  for (std::size_t at = 0; at < task.pressure.size(); ++at) {
    if (in_contact(task.pressure[at])) problem.cells.push_back(at);
  }
  const std::size_t m = problem.cells.size();
  std::array<Field, 3> directions{Field(2 * m, 0.0), Field(2 * m, 0.0), Field(2 * m)};
  problem.free_slip.resize(2 * m);
  for (std::size_t c = 0; c < m; ++c) {
    const std::size_t at = problem.cells[c];
    problem.bound.push_back(task.pressure[at]);
    problem.free_slip[c] = task.free_slip[at];
    problem.free_slip[m + c] = task.free_slip[task.pressure.size() + at];
    directions[0][c] = directions[1][m + c] = 1.0;
    const std::size_t i = at / box_.ny, j = at % box_.ny;
    directions[2][c] = -(task.y0 + static_cast<double>(j) * box_.dy);
    directions[2][m + c] =
        task.x0 + (static_cast<double>(i) + (task.rolls ? spin_lead : 0.0)) * box_.dx;
  }
  for (std::size_t from = 0; from < task.slip_part.size(); from += task.pressure.size()) {
    for (const std::size_t at : problem.cells)
      problem.slip_part.push_back(task.slip_part[from + at]);
  }
  for (int k = 0; k < 3; ++k) {
    if (drive[k].is_force()) {
      problem.modes.push_back({std::move(directions[k]), drive[k].value / box_.cell_area(), k});
    } else {
      apply_slip_part(problem, directions[k]);
      add_scaled(drive[k].value, directions[k], problem.free_slip);
    }
  }
  problem.floats = floats_ && m == box_.surface_size();
  problem.stiffness = stiffness_of(task.pressure);
  const double pressure = largest_of(m, [&](std::size_t c) { return problem.bound[c]; });
  problem.bound = friction.bound(std::move(problem.bound));
  for (std::size_t c = 0; c < m && !task.factor.empty(); ++c) {
    problem.bound[c] *= std::max(task.factor[problem.cells[c]], smallest_factor);
  }
  const double bound = largest_of(m, [&](std::size_t c) { return problem.bound[c]; });
  problem.smallest_shear = smallest_fraction * std::min(bound, pressure);
  if (task.rolls) let_roll(problem);
  stretch_to_circle(problem, friction.stretch());
  return problem;
}

void ShearSolver::Level::let_roll(ShearProblem& problem) const {
  problem.carried = static_cast<std::size_t>(box_.ny);
  for (double& slip : problem.free_slip) slip *= box_.dx;
  if (problem.cells.empty()) return;
  // Slip during a passage through the whole contact is divided by its length in cells.
  const auto rows = problem.cells.back() / box_.ny - problem.cells.front() / box_.ny + 1;
  problem.stiffness *= 0.5 * static_cast<double>(rows);
  // Slip per cell rolled due to a unit motion; moments are about the origin.
  const std::size_t m = problem.size();
  for (ShearProblem::Mode& mode : problem.modes) {
    mode.own_arms = mode.direction;
    for (std::size_t c = m; c < 2 * m && mode.axis == 2; ++c) {
      mode.own_arms[c] -= spin_lead * box_.dx;
    }
    for (double& slip : mode.direction) slip *= box_.dx;
    for (double& arm : mode.own_arms) arm *= box_.dx;
    mode.target *= box_.dx;
  }
}

BoxStart ShearSolver::Level::coarse_start(const BoxTask& task, const FrictionLaw& friction,
                                          const TangentialDrive& drive, double tol,
                                          double& operations) const {
  const auto coarsen = [&](const Field& field) { return coarsened(box_, field); };
  const BoxTask coarse{coarsen(task.pressure),
                       by_component(task.free_slip, coarsen),
                       task.slip_part.empty() ? Field{} : by_component(task.slip_part, coarsen, 3),
                       task.x0 + 0.5 * box_.dx,
                       task.y0 + 0.5 * box_.dy,
                       task.rolls,
                       task.factor.empty() ? Field{} : coarsen(task.factor)};
  Answer answer = coarser_->solve(coarse, friction, drive, {},
                                  std::max(coarse_shear_tol(coarser_->box()), tol), coarse_steps);
  operations += answer.operations;
  // The ratio of shear to pressure is smooth, and indicates slip at the edge.
  const Grid& grid = coarser_->box();
  const std::size_t n = grid.surface_size(), m = answer.cells.size();
  Field ratio(2 * n, 0.0), slips(n, 0.0);
  for (std::size_t c = 0; c < m; ++c) {
    const std::size_t at = answer.cells[c];
    ratio[at] = answer.result.shear[c] / coarse.pressure[at];
    ratio[n + at] = answer.result.shear[m + c] / coarse.pressure[at];
    slips[at] = answer.result.slipping[c];
  }
  const auto refine = [&](const Field& field) {
    return refined(box_, filled_outwards(grid, coarse.pressure, field));
  };
  BoxStart start{by_component(ratio, refine), {}, std::move(answer.result.motion)};
  const std::size_t fine = task.pressure.size();
  for (std::size_t at = 0; at < fine; ++at) {
    start.shear[at] *= task.pressure[at];
    start.shear[fine + at] *= task.pressure[at];
  }
  for (const double share : refine(slips)) start.slipping.push_back(share > 0.5);
  return start;
}

ShearSolver::Level::Answer ShearSolver::Level::solve(const BoxTask& task,
                                                     const FrictionLaw& friction,
                                                     const TangentialDrive& drive, BoxStart start,
                                                     double tol, int max_steps) const {
  Answer answer;
  if (start.shear.empty() && coarser_) {
    start = coarse_start(task, friction, drive, tol, answer.operations);
  }
  ShearProblem problem = problem_of(task, friction, drive);
  const std::size_t m = problem.size(), n = task.pressure.size();
  ShearStart begin{{}, {}, std::move(start.motion)};
  if (!start.shear.empty()) {
    begin.shear.resize(2 * m);
    for (std::size_t c = 0; c < m; ++c) {
      begin.shear[c] = start.shear[problem.cells[c]];
      begin.shear[m + c] = start.shear[n + problem.cells[c]];
      if (!start.slipping.empty()) begin.slipping.push_back(start.slipping[problem.cells[c]]);
    }
  }
  const Stretch& stretch = problem.stretch;
  stretch.inverse().apply(begin.shear);
  ShearApplier applier(problem);
  const auto iterate = task.rolls ? solve_steady_rolling : solve_partial_slip;
  answer.result = iterate(problem, applier, std::move(begin), tol, max_steps);
  stretch.apply(answer.result.shear);
  stretch.inverse().apply(answer.result.slip);
  if (task.rolls) {
    for (double& slip : answer.result.slip) slip /= box_.dx;
  }
  if (friction.prevents_slip()) {
    answer.result.energy_gap = std::numeric_limits<double>::quiet_NaN();
  }
  answer.cells = std::move(problem.cells);
  answer.applications = applier.applications();
  answer.operations += applier.operations();
  return answer;
}

struct ShearSolver::Kept {
  std::mutex mutex;
  std::shared_ptr<const Level> level;
};

ShearSolver::ShearSolver(const Grid& grid, operators::TangentialInfluence influence)
    : grid_(grid), influence_(std::move(influence)), kept_(std::make_unique<Kept>()) {}
ShearSolver::~ShearSolver() = default;
ShearSolver::ShearSolver(ShearSolver&&) noexcept = default;
ShearSolver& ShearSolver::operator=(ShearSolver&&) noexcept = default;

std::shared_ptr<const ShearSolver::Level> ShearSolver::level(const Box& box, int margin) const {
  const std::lock_guard lock(kept_->mutex);
  auto& kept = kept_->level;
  if (kept && kept->box().nx == box.nx && kept->box().ny == box.ny && kept->margin() == margin) {
    return kept;
  }
  const double more = static_cast<double>(box.surface_size()) -
                      static_cast<double>(kept ? kept->box().surface_size() : 0);
  require_memory(more * (margin > 0 ? rolling_bytes : partial_slip_bytes), "partial slip");
  kept.reset();  // both together may exceed the memory
  const Grid grid = Box{0, 0, box.nx, box.ny, 0}.grid(grid_);
  kept = std::make_shared<const Level>(grid, margin, influence_);
  return kept;
}

double ShearSolver::self_influence(bool rolls) const {
  const std::lock_guard lock(kept_->mutex);
  if (!kept_->level) return 0.0;
  const auto& displacement = kept_->level->operators().displacement;
  return displacement.self_influence() - (rolls ? displacement.neighbour_influence() : 0.0);
}

namespace {

/// Copies shear, slip and stick state from the cells in contact of a box to the grid.
void unpack(const ShearResult& result, const std::vector<std::size_t>& cells, const Box& box,
            const Grid& grid, ShearSolution& solution) {
  const std::size_t n = grid.surface_size(), m = cells.size();
  for (std::size_t c = 0; c < m; ++c) {
    const std::size_t i = box.i0 + cells[c] / box.ny, j = box.j0 + cells[c] % box.ny;
    const std::size_t there = i * grid.ny + j;
    for (std::size_t k = 0; k < 2; ++k) {
      solution.shear[k * n + there] = result.shear[k * m + c];
      solution.slip[k * n + there] = result.slipping[c] ? result.slip[k * m + c] : 0.0;
    }
    solution.sticking[there] = !result.slipping[c];
  }
}

Field over(const Grid& grid, const Box& box, const Field& field) {
  Field values(box.surface_size());
  extract(field.data(), Box::surface(grid), values.data(), box);
  return values;
}

/// Solution without contact or friction.
ShearSolution without_shear(const Grid& grid, const TangentialDrive& drive) {
  const std::size_t n = grid.surface_size();
  ShearSolution solution;
  solution.shear.assign(2 * n, 0.0);
  solution.slip.assign(2 * n, 0.0);
  solution.sticking.assign(n, 0);
  for (int k = 0; k < 3; ++k) solution.motion[k] = drive[k].is_force() ? 0.0 : drive[k].value;
  return solution;
}

BoxStart start_in(const Box& box, const Grid& grid, const ShearTask& task, const Field& shear,
                  const std::array<double, 3>& motion) {
  BoxStart start;
  if (shear.empty()) return start;
  start.shear = by_component(shear, [&](const Field& field) { return over(grid, box, field); });
  if (task.sticking != nullptr) {
    for (const double sticks : over(grid, box, {task.sticking->begin(), task.sticking->end()})) {
      start.slipping.push_back(sticks == 0);
    }
  }
  for (int k = 0; k < 3; ++k) {
    if (task.drive[k].is_force()) start.motion.push_back(motion[k]);
  }
  return start;
}

}  // namespace

ShearSolution ShearSolver::solve(const ShearTask& task, const Field& shear,
                                 const std::array<double, 3>& motion, double tol,
                                 int max_steps) const {
  ShearSolution solution = without_shear(grid_, task.drive);
  const bool touches = std::any_of(task.pressure.begin(), task.pressure.end(), in_contact);
  if (!touches || task.friction.is_frictionless()) return solution;
  const Box box = slipping_box(grid_, task.pressure, task.previous_shear);
  const auto level_of_box = level(box, task.rolls ? rolling_margin : 0);
  const auto boxed = [&](const Field& field) { return over(grid_, box, field); };
  BoxTask part{boxed(task.pressure),
               Field(2 * box.surface_size(), 0.0),
               task.slip_part != nullptr ? by_component(*task.slip_part, boxed, 3) : Field{},
               grid_.x()[box.i0],
               grid_.y()[box.j0],
               task.rolls,
               task.factor.empty() ? Field{} : boxed(task.factor)};
  if (!task.free_slip.empty()) part.free_slip = by_component(task.free_slip, boxed);
  PreviousDisplacement own;
  PreviousDisplacement& slid = task.slid != nullptr ? *task.slid : own;
  const bool known = slid.box == box && !slid.displacement.empty();
  if (!task.previous_shear.empty() && !known) {
    ComplexField work;
    slid = {box, by_component(task.previous_shear, boxed)};
    level_of_box->operators().displacement.apply(slid.displacement.data(), slid.displacement.data(),
                                                 work);
  }
  if (!slid.displacement.empty()) add_scaled(1.0, slid.displacement, part.free_slip);
  const Level::Answer answer = level_of_box->solve(
      part, task.friction, task.drive, start_in(box, grid_, task, shear, motion), tol, max_steps);
  const ShearResult& result = answer.result;
  unpack(result, answer.cells, box, grid_, solution);
  for (int k = 0, mode = 0; k < 3; ++k) {
    if (task.drive[k].is_force()) solution.motion[k] = result.motion[mode++];
  }
  solution.force = forces(grid_, solution.shear);
  solution.friction_work = grid_.cell_area() * dot(solution.shear, solution.slip);
  solution.error = result.error;
  solution.energy_gap = grid_.cell_area() * result.energy_gap;
  solution.steps = result.steps;
  solution.iterations = result.iterations;
  solution.fallbacks = result.fallbacks;
  solution.operator_applications = answer.applications;
  solution.work = answer.operations / level_of_box->operators().displacement.cost();
  solution.converged = result.converged;
  return solution;
}

std::array<double, 3> forces(const Grid& grid, const Field& shear) {
  const std::size_t n = grid.surface_size();
  const std::vector<double> x = grid.x(), y = grid.y();
  const double area = grid.cell_area();
  return {area * ordered_sum(n, [&](std::size_t at) { return shear[at]; }),
          area * ordered_sum(n, [&](std::size_t at) { return shear[n + at]; }),
          area * ordered_sum(n, [&](std::size_t at) {
            return x[at / grid.ny] * shear[n + at] - y[at % grid.ny] * shear[at];
          })};
}

}  // namespace samcontact::contact
