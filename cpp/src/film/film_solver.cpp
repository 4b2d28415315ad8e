// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/film_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::film {
namespace {

/// Accuracy of the linear systems: loosest, loosest where a few cells have most of the residual (a
/// boundary layer, or a large error), finest, and relative to the error of the state.
constexpr double loosest = 0.1, loosest_for_few = 1e-2, finest = 1e-4, of_error = 0.1;
constexpr double large_error = 30.0;
/// Largest change in a step: of the pressure, relative to its maximum, and of the distance of a
/// value from its bound, relative to this distance.
constexpr double largest_change = 0.5, of_barrier = 0.9;
/// Reductions of a step whose residual rises.
constexpr int max_halvings = 4;
/// Distance of the film from the layer, in thicknesses of the layer, above which the pressure of
/// the layer follows from the film; below, its logarithm is iterated.
constexpr double far_film = 10.0;
/// Tolerance of the law of the boundary layer relative to that of the flow.
constexpr double layer_tol_ratio = 10.0;
constexpr double tiny = 1e-300;

double sum_of(const Field& field) {
  return ordered_sum(field.size(), [&](std::size_t i) { return field[i]; });
}

double length(const Field& field) {
  return std::sqrt(ordered_dot(field.data(), field.data(), field.size()));
}

}  // namespace

class FilmSolver::Newton {
 public:
  Newton(FilmSolver& solver, const FilmProblem& problem, const Reynolds& reynolds,
         const BoundaryLayer& layer, const FilmHistory& history, const LubricantTable& lubricant,
         FilmState start)
      : solver_(solver),
        problem_(problem),
        reynolds_(reynolds),
        layer_(layer),
        history_(history),
        lubricant_(lubricant),
        n_(problem.gap.size()),
        area_(solver.grid_.cell_area()),
        s_(std::move(start)),
        cavitated_(n_),
        slopes_{Star(reynolds.lattice()), Star(reynolds.lattice()), Star(reynolds.lattice())} {
    for (std::size_t i = 0; i < n_; ++i) cavitated_[i] = s_.void_fraction[i] > 0 ? 1 : 0;
    for (std::size_t i = 0; i < n_; ++i) s_.fluid_pressure[i] *= cavitated_[i] ? 0.0 : 1.0;
    find_film(s_);
    if (has_layer()) enter_layer();
  }

  FilmSolution run(const NewtonSettings& settings);

 private:
  bool has_layer() const { return layer_.thickness > 0; }
  double layer_pressure(double film) const {
    const double distance = std::max(film - layer_.thickness, 1e-3 * layer_.thickness);
    return layer_.pressure * std::pow(layer_.thickness / distance, 3);
  }
  void find_film(FilmState& state) const {
    Field pressure = state.fluid_pressure;
    for (std::size_t i = 0; i < n_; ++i) pressure[i] += state.boundary_pressure[i];
    state.film.resize(n_);
    solver_.elastic_.displace(pressure, state.film);
    for (std::size_t i = 0; i < n_; ++i) state.film[i] += problem_.gap[i] - state.approach;
  }
  static double lowest_film(const FilmState& state) {
    return *std::min_element(state.film.begin(), state.film.end());
  }
  /// Moves the surfaces apart until all films are thicker than the layer.
  void lift(FilmState& state, double beyond) const {
    const double lowest = lowest_film(state);
    if (lowest > layer_.thickness) return;
    const double up = 1.05 * (layer_.thickness - lowest) + beyond * layer_.thickness;
    state.approach -= up;
    for (double& h : state.film) h += up;
  }
  void enter_layer();
  Field outflow(const FilmState& state, Reynolds::Slopes* slopes) const;
  void find_layer();
  double error();
  double accuracy(double error, double tol) const;
  FilmChange change(double share, int max_steps);
  double step_limit(const FilmChange& change) const;
  FilmState moved(const FilmChange& change, double step, std::vector<char>& cavitated) const;
  void advance(const FilmChange& change);

  FilmSolver& solver_;
  const FilmProblem& problem_;
  const Reynolds& reynolds_;
  const BoundaryLayer& layer_;
  const FilmHistory& history_;
  const LubricantTable& lubricant_;
  std::size_t n_;
  double area_;
  FilmState s_;
  std::vector<char> cavitated_;
  Reynolds::Slopes slopes_;
  Field outflow_, stiffness_, lag_;
  double scale_ = 1.0, peak_ = 1.0, missing_load_ = 0.0, layer_error_ = 0.0;
};

void FilmSolver::Newton::enter_layer() {
  lift(s_, 0.05);
  for (std::size_t i = 0; i < n_; ++i) {
    double& p = s_.boundary_pressure[i];
    p = std::max(p, std::min(layer_pressure(s_.film[i]), 1e-3 * layer_.pressure));
  }
  find_film(s_);
  lift(s_, 0.05);
}

Field FilmSolver::Newton::outflow(const FilmState& state, Reynolds::Slopes* slopes) const {
  const FilmFields fields{state.fluid_pressure, state.film, state.void_fraction};
  Field sum = slopes != nullptr ? reynolds_.outflow(fields, *slopes) : reynolds_.outflow(fields);
  if (!(history_.step > 0)) return sum;
  const double rate = area_ / history_.step;
  for (std::size_t i = 0; i < n_; ++i) {
    const auto oil = lubricant_.at(state.fluid_pressure[i]);
    const double filling = 1 - state.void_fraction[i], h = state.film[i];
    sum[i] += rate * (history_.present * filling * oil.density * h - history_.content[i]);
    if (slopes == nullptr) continue;
    const double weight = rate * history_.present;
    slopes->pressure.entry(i, 0, 0) += weight * filling * oil.density_slope * h;
    slopes->film.entry(i, 0, 0) += weight * filling * oil.density;
    slopes->void_fraction.entry(i, 0, 0) -= weight * oil.density * h;
  }
  return sum;
}

/// Pressure of the boundary layer in logarithms: 3 p/(h - h_b) is its stiffness.
void FilmSolver::Newton::find_layer() {
  stiffness_.assign(n_, 0.0);
  lag_ = stiffness_;
  layer_error_ = 0.0;
  if (!has_layer()) return;
  for (std::size_t i = 0; i < n_; ++i) {
    double& p = s_.boundary_pressure[i];
    const double distance = s_.film[i] - layer_.thickness;
    if (distance > far_film * layer_.thickness) p = layer_pressure(s_.film[i]);
    const double excess = std::log(p / layer_.pressure) + 3 * std::log(distance / layer_.thickness);
    stiffness_[i] = 3 * p / distance;
    lag_[i] = -p * std::clamp(excess, -2.0, 2.0);
    layer_error_ = std::max(layer_error_, std::fabs(excess) * p);
  }
}

double FilmSolver::Newton::error() {
  outflow_ = outflow(s_, &slopes_);
  Field pressure(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    pressure[i] = s_.fluid_pressure[i] + s_.boundary_pressure[i];
  }
  peak_ = std::max(*std::max_element(pressure.begin(), pressure.end()), 1.0);
  std::vector<double> films;
  for (std::size_t i = 0; i < n_; ++i) {
    if (pressure[i] > 0.5 * peak_) films.push_back(s_.film[i]);
  }
  double central = 0.0;
  if (!films.empty()) {
    std::nth_element(films.begin(), films.begin() + std::ssize(films) / 2, films.end());
    central = films[films.size() / 2];
  }
  central = std::max({central, layer_.thickness, 1e-15});
  const double speed_scale = reynolds_.speed() * central * solver_.grid_.dy;
  const double time_scale = history_.step > 0 ? central * area_ / history_.step : 0.0;
  scale_ = std::max({speed_scale, time_scale, tiny});
  const double largest = largest_of(n_, [&](std::size_t i) { return std::fabs(outflow_[i]); });
  missing_load_ = problem_.has_load ? problem_.target - area_ * sum_of(pressure) : 0.0;
  find_layer();
  const double of_load = problem_.has_load ? std::fabs(missing_load_) / problem_.target : 0.0;
  return std::max(largest / scale_, of_load);
}

/// Required accuracy of the linear system at an error of the state.
double FilmSolver::Newton::accuracy(double error, double tol) const {
  if (has_layer() || error > large_error) {
    return std::clamp(of_error * error, finest, loosest_for_few);
  }
  return std::min(std::max({of_error * error, of_error * tol / error, finest}), loosest);
}

FilmChange FilmSolver::Newton::change(double share, int max_steps) {
  const double load = problem_.has_load ? problem_.target : peak_ * area_;
  return solver_.system_.solve(
      {slopes_, outflow_, cavitated_, stiffness_, lag_, missing_load_, problem_.has_load, load},
      share, max_steps);
}

double FilmSolver::Newton::step_limit(const FilmChange& change) const {
  const double largest =
      largest_of(n_, [&](std::size_t i) { return std::fabs(change.fluid_pressure[i]); });
  double step = std::min(1.0, largest_change * peak_ / std::max(largest, tiny));
  const double floor = layer_.thickness;
  const bool positive = has_layer() || lowest_film(s_) > 0;
  for (std::size_t i = 0; i < n_ && positive; ++i) {
    const double distance = s_.film[i] - floor;
    if (distance <= 0 || change.film[i] >= -of_barrier * distance) continue;
    const double limit = of_barrier * distance / -change.film[i];
    step = std::min(step, has_layer() ? limit : std::max(0.1, limit));
  }
  for (std::size_t i = 0; i < n_ && has_layer(); ++i) {
    const double p = s_.boundary_pressure[i], down = -change.boundary_pressure[i];
    if (down > of_barrier * p && p > 1e-3 * layer_.pressure) {
      step = std::min(step, of_barrier * p / down);
    }
  }
  return step;
}

FilmState FilmSolver::Newton::moved(const FilmChange& change, double step,
                                    std::vector<char>& cavitated) const {
  FilmState next = s_;
  next.approach += step * change.approach;
  for (std::size_t i = 0; i < n_; ++i) {
    const double p = s_.fluid_pressure[i] + step * change.fluid_pressure[i];
    const double voids = s_.void_fraction[i] + step * change.void_fraction[i];
    cavitated[i] = cavitated_[i] ? voids > 0 : p <= 0;
    next.fluid_pressure[i] = cavitated_[i] ? 0.0 : std::max(p, 0.0);
    next.void_fraction[i] = cavitated_[i] ? std::clamp(voids, 0.0, 1.0) : 0.0;
    const double layer = s_.boundary_pressure[i];
    next.boundary_pressure[i] = std::max(layer + step * change.boundary_pressure[i], 0.1 * layer);
  }
  find_film(next);
  return next;
}

void FilmSolver::Newton::advance(const FilmChange& change) {
  const double before = length(outflow_);
  double step = step_limit(change);
  FilmState next;
  std::vector<char> cavitated(n_);
  for (int n = 0;; ++n, step *= 0.5) {
    next = moved(change, step, cavitated);
    if (has_layer() && lowest_film(next) <= layer_.thickness) {
      if (n < max_halvings) continue;
      lift(next, 0.01);
    }
    const double allowed = has_layer() || history_.step > 0 ? 2.0 : 1.0;
    if (n >= max_halvings || before < 1e-3 * scale_) break;
    if (length(outflow(next, nullptr)) < allowed * before) break;
  }
  s_ = std::move(next);
  cavitated_ = std::move(cavitated);
}

FilmSolution FilmSolver::Newton::run(const NewtonSettings& settings) {
  FilmSolution found;
  const double applied = solver_.elastic_.applications();
  for (;; ++found.iterations) {
    check_interrupt();
    found.error = error();
    const bool layer_agrees = layer_error_ <= layer_tol_ratio * settings.tol * peak_;
    found.converged = found.error <= settings.tol && layer_agrees;
    if (found.converged || found.iterations >= settings.max_iterations ||
        !std::isfinite(found.error)) {
      break;
    }
    const FilmChange step = change(accuracy(found.error, settings.tol), settings.max_krylov_steps);
    if (step.film.empty()) break;
    found.krylov_steps += step.steps;
    advance(step);
  }
  found.error = std::max(found.error, layer_error_ / (layer_tol_ratio * peak_));
  found.load = area_ * (sum_of(s_.fluid_pressure) + sum_of(s_.boundary_pressure));
  found.applications = solver_.elastic_.applications() - applied;
  found.fill = found.iterations > 0 ? solver_.system_.fill() : 0.0;
  found.state = std::move(s_);
  return found;
}

FilmSolver::FilmSolver(const Grid& grid, const operators::SurfaceInfluence& influence)
    : grid_(grid), elastic_(grid, influence), system_(grid_, elastic_) {}

FilmSolution FilmSolver::solve(const FilmProblem& problem, const FaceVelocities& velocities,
                               const LubricantTable& lubricant, const FlowSettings& flow,
                               const BoundaryLayer& layer, const FilmHistory& history,
                               FilmState start, const NewtonSettings& settings) {
  const std::size_t n = grid_.surface_size();
  for (const Field* field : {&problem.gap, static_cast<const Field*>(&start.fluid_pressure),
                             static_cast<const Field*>(&start.boundary_pressure),
                             static_cast<const Field*>(&start.void_fraction)}) {
    if (field->size() != n) {
      throw std::invalid_argument("fields of a film must have a value for each cell of the grid");
    }
  }
  FlowSettings limited = flow;
  limited.boundary_thickness = layer.thickness;
  const Reynolds reynolds(grid_, velocities, lubricant, std::move(limited));
  return Newton(*this, problem, reynolds, layer, history, lubricant, std::move(start))
      .run(settings);
}

}  // namespace samcontact::film
