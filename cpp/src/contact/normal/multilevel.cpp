// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/multilevel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <utility>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/active_set.hpp"
#include "samcontact/contact/normal/coarsening.hpp"
#include "samcontact/contact/normal/polonsky_keer.hpp"
#include "samcontact/contact/normal/window.hpp"

namespace samcontact::contact {
namespace {

/// Grids are halved while their shorter side keeps this number of cells.
constexpr int coarsest_side = 64;
/// A start needs no higher accuracy: finer roughness changes the contact anyway.
constexpr double coarse_tol = 1e-3;
/// Required reduction of the error by the approximate operator in one round: in the first round
/// large, since the error of a start is at short wavelengths, which the approximate operator
/// resolves; later as large as the exact operator is expected to confirm.
constexpr double first_gain = 1e-3, gain = 1e-2;
/// The last round aims below tol, so that the exact operator confirms it.
constexpr double round_safety = 0.5;
constexpr int max_steps_per_round = 300;
/// Consecutive rounds that fail to halve the error before the method without preconditioner takes
/// over.
constexpr int max_failed_rounds = 2;
/// Accumulated rounding error of the load in the steps of a round, relative to the load. If the
/// displacement has no mean, nothing restrains the mean pressure, and steps along nearly solved
/// directions are long.
constexpr double max_load_error = 1e-12;

/// Gap assigned to cells without a body, relative to the largest closed gap; larger in each further
/// attempt.
constexpr double far_off = 4, further_off = 64;
constexpr int max_attempts = 4;

}  // namespace

class Multilevel::Level {
 public:
  Level(const Grid& grid, const operators::SurfaceInfluence& influence)
      : grid_(grid), displacement_(grid, influence) {}

  /// Counts the work in units of fft::filter_cost. is_start: the solution only serves as a start,
  /// for which its pressure suffices.
  Solution solve(const Field& initial_gap, const RigidModes& modes, Field pressure, double tol,
                 int max_iterations, bool is_start = false) const;

  const Grid& grid() const { return grid_; }
  const operators::SurfaceDisplacement& displacement() const { return displacement_; }
  std::shared_ptr<const NearOperators> near(int nx, int ny) const;

 private:
  Field coarse_start(const Field& gap, const RigidModes& modes, int max_iterations,
                     double& work) const;
  /// Rounding error of gaps under load if the displacement has no mean [m]; otherwise it is
  /// negligible.
  double rounding(const Field& gap, double lowest, const RigidModes& modes) const;

  Grid grid_;
  operators::SurfaceDisplacement displacement_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const NearOperators> near_;  // of the last box size
  mutable std::unique_ptr<Level> coarser_;
};

namespace {

/// One solve on one grid: rounds of the active-set iteration between exact evaluations.
class Rounds {
 public:
  using Near = std::function<std::shared_ptr<const NearOperators>(int nx, int ny)>;

  Rounds(const Grid& grid, const operators::NormalDisplacement& displacement, Near near,
         const Field& initial_gap, const RigidModes& modes, Field pressure, bool warm,
         double rounding, bool whole)
      : grid_(grid),
        displacement_(displacement),
        near_(std::move(near)),
        initial_gap_(initial_gap),
        modes_(modes),
        warm_(warm),
        whole_(whole),
        box_{},
        u_(initial_gap.size()) {
    solution_.tractions.pressure = std::move(pressure);
    solution_.gap.resize(initial_gap.size());
    solution_.rounding = rounding;
    met_ = modes_.meet_anywhere(initial_gap_, solution_.tractions.pressure);
  }

  /// One round without a check: the start of the next finer grid.
  Solution start(double tol, int max_iterations) {
    if (!met_) return {};  // the coarse cells end before the line of action of the load
    evaluate();
    if (solution_.error > tol) {
      choose_box();
      round(true, tol, std::min(max_iterations, max_steps_per_round));
    }
    return std::move(solution_);
  }

  Solution run(double tol, int max_iterations) {
    double last_error = INFINITY;
    for (int stalled = 0;; last_error = solution_.error) {
      evaluate();
      solution_.converged = solution_.error <= tol;
      if (solution_.converged || solution_.iterations >= max_iterations) {
        return std::move(solution_);
      }
      const bool grown = choose_box();
      stalled = grown || solution_.error < 0.5 * last_error ? 0 : stalled + 1;
      if (stalled == max_failed_rounds) break;
      round(std::isinf(last_error), tol,
            std::min(max_iterations - solution_.iterations, max_steps_per_round));
    }
    return plain(tol, max_iterations);
  }

 private:
  void evaluate() {
    check_interrupt();
    keep_load();
    displacement_.apply(solution_.tractions.pressure.data(), u_.data(), work_);
    ++solution_.operator_applications;
    solution_.work += displacement_.cost();
    for_each_cell(std::ssize(u_),
                  [&](std::ptrdiff_t i) { solution_.gap[i] = initial_gap_[i] + u_[i]; });
    solution_.motion = modes_.close(solution_.tractions.pressure, solution_.gap);
    solution_.error =
        complementarity_error(solution_.tractions.pressure, u_, solution_.gap, solution_.rounding);
  }

  void keep_load() {
    Field& p = solution_.tractions.pressure;
    if (!modes_.is_met(p, max_load_error)) modes_.meet_anywhere(initial_gap_, p);
  }

  /// Part of a surface field over the box.
  Field part(const Field& field) const {
    Field over(box_.surface_size());
    extract(field.data(), Box::surface(grid_), over.data(), box_);
    return over;
  }

  /// Chooses the box; true if contact has become possible outside the previous one.
  bool choose_box() {
    const Box box =
        whole_
            ? Box::surface(grid_)
            : modes_.united(possible_contact(grid_, solution_.tractions.pressure, solution_.gap));
    if (box_.contains(box)) return false;
    box_ = with_margin(grid_, box, box_);
    return true;
  }

  void round(bool first, double tol, int max_iterations) {
    const auto near = near_(box_.nx, box_.ny);
    const bool exact = near->displacement.is_exact();
    NearProblem problem{*near, part(initial_gap_), modes_.over(box_),
                        displacement_.self_influence()};
    Field pressure = part(solution_.tractions.pressure);
    Field displacement = part(u_);
    if (!exact) {
      Field cheap(displacement.size());
      near->displacement.apply(pressure.data(), cheap.data(), work_);
      solution_.work += near->displacement.cost();
      for (std::size_t i = 0; i < cheap.size(); ++i) problem.gap[i] += displacement[i] - cheap[i];
      std::swap(displacement, cheap);
    }
    const double target = exact ? 0.0 : solution_.error * (first ? first_gain : gain);
    const auto result =
        solve_active_set(problem, std::move(pressure), std::move(displacement), first && !warm_,
                         std::max(target, round_safety * tol), max_iterations);
    std::fill(solution_.tractions.pressure.begin(), solution_.tractions.pressure.end(), 0.0);
    insert(result.pressure.data(), box_, solution_.tractions.pressure.data(), Box::surface(grid_));
    solution_.iterations += result.iterations;
    solution_.negative_curvatures += result.negative_curvature;
    solution_.work += result.operations;
  }

  Solution plain(double tol, int max_iterations) {
    Solution end =
        polonsky_keer(displacement_, initial_gap_, modes_, std::move(solution_.tractions.pressure),
                      tol, max_iterations - solution_.iterations, solution_.rounding);
    end.iterations += solution_.iterations;
    end.negative_curvatures += solution_.negative_curvatures;
    end.work = end.work * displacement_.cost() + solution_.work;
    end.operator_applications += solution_.operator_applications;
    return end;
  }

  const Grid& grid_;
  const operators::NormalDisplacement& displacement_;
  const Near near_;
  const Field& initial_gap_;
  const RigidModes& modes_;
  const bool warm_;
  bool met_ = true;
  const bool whole_;  // whether the box is the grid: faces have a place on it
  Box box_;
  Field u_;
  ComplexField work_;
  Solution solution_;
};

}  // namespace

std::shared_ptr<const NearOperators> Multilevel::Level::near(int nx, int ny) const {
  const std::lock_guard lock(mutex_);
  if (!near_ || near_->displacement.nx() != nx || near_->displacement.ny() != ny) {
    near_ = std::make_shared<const NearOperators>(Box{0, 0, nx, ny, 0}.grid(grid_),
                                                  displacement_.influence(), displacement_.ends());
  }
  return near_;
}

Field Multilevel::Level::coarse_start(const Field& gap, const RigidModes& modes, int max_iterations,
                                      double& work) const {
  {
    const std::lock_guard lock(mutex_);
    if (!coarser_) coarser_ = std::make_unique<Level>(coarsened(grid_), displacement_.influence());
  }
  const Grid& coarse = coarser_->grid();
  const Solution start =
      coarser_->solve(coarsened(grid_, gap), modes.coarsened(), Field(coarse.surface_size(), 0.0),
                      coarse_tol, max_iterations, true);
  work += start.work;
  const Field& found = start.tractions.pressure;
  return found.empty() ? Field(grid_.surface_size(), 0.0) : refined(grid_, found);
}

double Multilevel::Level::rounding(const Field& gap, double lowest, const RigidModes& modes) const {
  const Given& normal = modes.normal();
  if (!normal.is_force() || !(grid_.period.x > 0 && grid_.period.y > 0)) return 0.0;
  const double longest = std::max(grid_.nx * grid_.dx, grid_.ny * grid_.dy);
  const double area = grid_.cell_area() * static_cast<double>(grid_.surface_size());
  return rounding_error(
      gap, lowest,
      normal.value / area *
          displacement_.influence().wave_compliance(2 * std::numbers::pi / longest));
}

Solution Multilevel::Level::solve(const Field& initial_gap, const RigidModes& modes, Field pressure,
                                  double tol, int max_iterations, bool is_start) const {
  const Given& normal = modes.normal();
  const double lowest = *std::min_element(initial_gap.begin(), initial_gap.end());
  if (auto open = separated(initial_gap, lowest, normal)) return *std::move(open);
  double work = 0.0;
  const bool warm = !is_zero(pressure);
  // Cells of a coarser grid keep their distance from faces only if they fill the grid.
  const bool fits = !displacement_.ends() || grid_.ny % 2 == 0;
  if (!warm && fits && std::min(grid_.nx, grid_.ny) >= coarsest_side && grid_.can_be_coarsened()) {
    pressure = coarse_start(initial_gap, modes, max_iterations, work);
  }
  const auto near_of = [this](int nx, int ny) { return near(nx, ny); };
  Rounds rounds(grid_, displacement_, near_of, initial_gap, modes, std::move(pressure), warm,
                rounding(initial_gap, lowest, modes), displacement_.ends() != nullptr);
  Solution solution =
      is_start ? rounds.start(tol, max_iterations) : rounds.run(tol, max_iterations);
  solution.work += work;
  return solution;
}

Multilevel::Multilevel(const Grid& grid, const operators::SurfaceInfluence& influence)
    : finest_(std::make_unique<Level>(grid, influence)) {}
Multilevel::~Multilevel() = default;
Multilevel::Multilevel(Multilevel&&) noexcept = default;
Multilevel& Multilevel::operator=(Multilevel&&) noexcept = default;

Solution Multilevel::solve_with_ends(const Field& initial_gap, const RigidModes& modes,
                                     Field pressure, double tol, int max_iterations) const {
  const Given& normal = modes.normal();
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t i = 0; i < initial_gap.size(); ++i) {
    if (std::isinf(initial_gap[i])) {
      pressure[i] = 0.0;
      continue;
    }
    lowest = std::min(lowest, initial_gap[i]);
    highest = std::max(highest, initial_gap[i]);
  }
  // No displacement exceeds the one due to the whole load on a single cell.
  const double closed = normal.is_force() ? std::fabs(displacement().self_influence()) *
                                                normal.value / finest_->grid().cell_area()
                                          : std::max(0.0, normal.value - lowest);
  double beyond = far_off * (closed + (highest - lowest));
  const RigidModes bodies = modes.within(highest);
  for (int n = 0; n < max_attempts; ++n, beyond *= further_off) {
    Field gap = initial_gap;
    for (double& g : gap) g = std::isinf(g) ? highest + beyond : g;
    Solution solution = finest_->solve(gap, bodies, pressure, tol, max_iterations);
    bool touches = false;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (!std::isinf(initial_gap[i])) continue;
      touches = touches || in_contact(solution.tractions.pressure[i]);
      solution.gap[i] = initial_gap[i];
    }
    if (!touches) return solution;
  }
  throw ConvergenceError("the contact extends into cells without a body (infinite gap)",
                         max_iterations, INFINITY);
}

const operators::SurfaceDisplacement& Multilevel::displacement() const {
  return finest_->displacement();
}

Solution Multilevel::solve(const Field& initial_gap, const Drive& drive, Field pressure, double tol,
                           int max_iterations) const {
  const Grid& grid = finest_->grid();
  const RigidModes modes(drive, grid);
  const RigidMotion held = drive.held();
  Field tilted;
  if (held.is_tilted()) {
    const Lowering lowering(grid, held);
    tilted = initial_gap;
    for (std::size_t i = 0; i < tilted.size(); ++i) tilted[i] -= lowering(i);
  }
  const Field& gap = held.is_tilted() ? tilted : initial_gap;
  const auto has_none = [](double g) { return std::isinf(g); };
  Solution solution = std::any_of(gap.begin(), gap.end(), has_none)
                          ? solve_with_ends(gap, modes, std::move(pressure), tol, max_iterations)
                          : finest_->solve(gap, modes, std::move(pressure), tol, max_iterations);
  solution.work /= displacement().cost();
  for (int k = 0; k < 2; ++k) solution.motion.tilt[k] += held.tilt[k];
  const Field& p = solution.tractions.pressure;
  const Given& normal = drive.normal;
  solution.load =
      normal.is_force()
          ? normal.value
          : grid.cell_area() * ordered_sum(p.size(), [&](std::size_t i) { return p[i]; });
  solution.moment = moments(grid, p);
  for (int k = 0; k < 2; ++k) {
    if (drive.tilt[k].is_force()) solution.moment[k] = drive.tilt[k].value;
  }
  return solution;
}

}  // namespace samcontact::contact
