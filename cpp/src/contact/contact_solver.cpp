// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/contact_solver.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/lagged_displacement.hpp"
#include "samcontact/contact/normal/attraction.hpp"

namespace samcontact::contact {
namespace {

/// Fraction of the grid in contact above which no larger grid would contain the contact.
constexpr double covered = 0.9;

/// Largest repulsion in the outermost cells of the grid, at the edges normal to x and to y.
std::array<double, 2> edge_repulsion(const Grid& grid, const Field& repulsion) {
  std::array<double, 2> largest{};
  const auto at = [&](int i, int j) {
    return repulsion[static_cast<std::size_t>(i) * grid.ny + j];
  };
  for (int j = 0; grid.period.x == 0 && j < grid.ny; ++j) {
    largest[0] = std::max({largest[0], at(0, j), at(grid.nx - 1, j)});
  }
  for (int i = 0; grid.period.y == 0 && i < grid.nx; ++i) {
    largest[1] = std::max({largest[1], at(i, 0), at(i, grid.ny - 1)});
  }
  return largest;
}

operators::SurfaceInfluence influence_of(const Grid& grid,
                                         const std::array<operators::SharedMedium, 2>& bodies,
                                         const FrictionLaw& friction,
                                         const operators::HeatingPair& heating) {
  require_deformable(!bodies[0]->is_rigid() || !bodies[1]->is_rigid());
  operators::SurfaceInfluence influence;
  for (int b = 0; b < 2; ++b) {
    const bool lasts = heating[b].age == operators::Heating::infinity();
    if (grid.period.is_on() && heating[b].is_on() && lasts) {
      throw std::invalid_argument("periodic surfaces have no steady state with heat");
    }
    if (heating[b].is_on() && bodies[b]->is_rigid()) {
      throw std::invalid_argument("body " + std::to_string(b + 1) +
                                  " is rigid and has no thermal expansion: it cannot be heated");
    }
    influence.add(bodies[b], friction.shear_over_pressure(b), heating[b]);
  }
  return influence;
}

/// Throws std::invalid_argument for an approach at which periodic surfaces touch everywhere.
void require_below_mean(const Grid& grid, const Field& gap, Given normal) {
  if (grid.period.x == 0 || grid.period.y == 0 || normal.is_force()) return;
  const double mean = ordered_sum(gap.size(), [&](std::size_t i) { return gap[i]; }) / gap.size();
  require(normal.value < mean, "approach",
          "less than the mean gap, " + to_short_text(mean, 6) +
              " m, at which periodic surfaces touch everywhere and any larger load is possible",
          normal.value, "prescribe the load instead");
}

}  // namespace

void require_deformable(bool any) {
  if (any) return;
  throw std::invalid_argument("body1 and body2 are both rigid: at least one must be deformable");
}

void require_possible(const Grid& grid, const ContactLaw& law, const Field& gap,
                      const Drive& drive) {
  require_valid(drive, law, grid);
  require_below_mean(grid, gap, drive.normal);
}

void require_solvable(const Grid& grid, const ContactLaw& law, const Field& gap, const Drive& drive,
                      const Field& initial_pressure, const ContactSettings& settings) {
  require_gap(gap, grid, "gap");
  if (!initial_pressure.empty()) require_surface(initial_pressure, grid, "initial_pressure");
  require_possible(grid, law, gap, drive);
  require(settings.tol >= 1e-13 && settings.tol < 1, "tol", "in [1e-13, 1)", settings.tol);
  require(settings.max_iterations > 0, "max_iterations", "an integer > 0", settings.max_iterations);
}

std::string edge_warning(const Grid& grid, const Field& repulsion, const std::string& what) {
  const auto [at_x, at_y] = edge_repulsion(grid, repulsion);
  if (!in_contact(at_x) && !in_contact(at_y)) return {};
  const double peak = *std::max_element(repulsion.begin(), repulsion.end());
  const auto percent = [peak](double p) { return to_short_text(100 * p / peak) + " %"; };
  std::string where, what_helps;
  if (in_contact(at_x)) {
    where = percent(at_x) + " of the maximum at the edges normal to x";
    what_helps = "nx dx";
  }
  if (in_contact(at_y)) {
    where += where.empty() ? percent(at_y) + " of the maximum at the edges normal to y"
                           : " and " + percent(at_y) + " at those normal to y";
    what_helps += what_helps.empty() ? "ny dy" : " and ny dy";
  }
  const auto touching = std::count_if(repulsion.begin(), repulsion.end(), in_contact);
  const double share = static_cast<double>(touching) / static_cast<double>(repulsion.size());
  const std::string cover =
      share >= covered ? ", and covers " + to_short_text(100 * share) + " % of the grid" : "";
  return "at " + what + " the contact reaches the edge of the grid (" +
         to_short_text(grid.nx * grid.dx, 4) + " m x " + to_short_text(grid.ny * grid.dy, 4) +
         " m), with a pressure of " + where + cover + ": enlarge " + what_helps;
}

GridTooSmallError too_small(const Grid& grid, const Field& repulsion, const std::string& warning) {
  const auto [at_x, at_y] = edge_repulsion(grid, repulsion);
  return {warning + ", or set on_border=\"warn\"", in_contact(at_x), in_contact(at_y)};
}

ContactSolver::ContactSolver(const Grid& grid, const operators::SharedMedium& body1,
                             const operators::SharedMedium& body2, const FrictionLaw& friction,
                             const operators::HeatingPair& heating, SharedContactLaw law)
    : ContactSolver(grid, influence_of(grid, {body1, body2}, friction, heating), friction,
                    std::move(law)) {
  assert(!friction.sticks());
}

ContactSolver::ContactSolver(const Grid& grid, const operators::SurfaceInfluence& influence,
                             FrictionLaw friction, SharedContactLaw law)
    : grid_(grid),
      friction_(std::move(friction)),
      law_(std::move(law)),
      heated_(influence.is_heated()),
      multilevel_(grid, influence) {
  if (heated_ && law_->attracts()) {
    throw std::invalid_argument(
        "heating cannot be combined with a contact law with attraction: use hard contact");
  }
  if (law_->varies()) adhesive_ = std::make_unique<AdhesiveContact>(grid, influence, law_);
}

void ContactSolver::require_solved(const Solution& solution, const Drive& drive,
                                   const ContactSettings& settings) const {
  const bool finite = is_finite(solution);
  const bool grows = solution.negative_curvatures > 0;
  if (heated_ && !drive.normal.is_force() &&
      (finite ? is_unstable(solution.tractions.pressure) : grows)) {
    throw ConvergenceError("thermoelastic instability at " + describe(drive) +
                               ": thermal expansion exceeds elastic compression, so the contact "
                               "grows without bound; prescribe the load instead",
                           solution.iterations, solution.error);
  }
  if (!finite) {
    throw ConvergenceError(
        "contact did not converge at " + describe(drive) + ": the solution is not finite",
        solution.iterations, solution.error);
  }
  if (heated_ && !solution.converged && solution.negative_curvatures > 0) {
    throw ConvergenceError("possible thermoelastic instability at " + describe(drive) +
                               ": frictional heating makes the contact operator indefinite in " +
                               std::to_string(solution.negative_curvatures) +
                               " iterations; error " + to_short_text(solution.error) + " after " +
                               std::to_string(solution.iterations) + " iterations, tol " +
                               to_text(settings.tol) + ": reduce the load, speed or friction",
                           solution.iterations, solution.error);
  }
  if (!solution.converged) {
    throw ConvergenceError("contact did not converge at " + describe(drive) + ": error " +
                               to_short_text(solution.error) + " after " +
                               std::to_string(solution.iterations) + " iterations, tol " +
                               to_text(settings.tol) +
                               ": increase max_iterations or tol, or use smaller cells",
                           solution.iterations, solution.error);
  }
}

Solution ContactSolver::solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                              const ContactSettings& settings) const {
  require_solvable(grid_, *law_, gap, drive, initial_pressure, settings);
  if (adhesive_) return solve_adhesive(gap, drive, initial_pressure, settings);
  const Attraction attraction(*law_, grid_, multilevel_.displacement(), gap);
  const Drive repelling = attraction.repelling(drive);
  require_reach(repelling, grid_, gap);
  Field repulsion = attraction.repulsion(initial_pressure);
  repulsion.resize(gap.size(), 0.0);
  for (double& r : repulsion) r = std::max(r, 0.0);

  Solution solution =
      multilevel_.displacement().has_rest()
          ? solve_coupled(attraction.gap(), repelling, std::move(repulsion), settings)
          : multilevel_.solve(attraction.gap(), repelling, std::move(repulsion), settings.tol,
                              settings.max_iterations);
  require_solved(solution, drive, settings);
  solution.edge_warning = edge_warning(grid_, solution.tractions.pressure, describe(drive));
  if (!solution.edge_warning.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, solution.tractions.pressure, solution.edge_warning);
  }
  solution.tractions = friction_.tractions(std::move(solution.tractions.pressure));
  return attraction.with_attraction(std::move(solution), drive);
}

Solution ContactSolver::solve_adhesive(const Field& gap, const Drive& drive,
                                       const Field& initial_pressure,
                                       const ContactSettings& settings) const {
  Field start = initial_pressure;
  start.resize(gap.size(), 0.0);
  const auto solve = [&](const Field& separated, double tol) {
    Solution found = adhesive_->solve(separated, drive, start, tol, settings.max_iterations);
    start = found.tractions.pressure;
    return found;
  };
  Solution solution;
  if (multilevel_.displacement().has_rest()) {
    ComplexField scratch;
    // Shear is proportional to the pressure on which friction depends, which takes its place.
    const LaggedContact contact{
        [&](const Field& rubbing, Field& separation) {
          multilevel_.displacement().apply_rest(rubbing.data(), separation.data(), scratch);
        },
        [&](const Field& lagged, const Field& /*rubbing*/, double tol) {
          Solution found = solve(lagged, tol);
          Field pushed = repulsion(*law_, found.tractions.pressure, found.gap);
          found.tractions.pressure = rubbing_pressure(*law_, std::move(pushed), found.gap);
          return found;
        }};
    solution = solve_lagged(contact, grid_, gap, drive, Field(gap.size(), 0.0), settings.tol);
    solution.tractions.pressure = start;
  } else {
    solution = solve(gap, settings.tol);
  }
  require_solved(solution, drive, settings);
  const Field pushed = repulsion(*law_, solution.tractions.pressure, solution.gap);
  solution.edge_warning = edge_warning(grid_, pushed, describe(drive));
  if (!solution.edge_warning.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, pushed, solution.edge_warning);
  }
  Field pressure = std::move(solution.tractions.pressure);
  solution.tractions = friction_.tractions(rubbing_pressure(*law_, pushed, solution.gap));
  solution.tractions.pressure = std::move(pressure);
  return solution;
}

bool ContactSolver::is_unstable(const Field& pressure) const {
  Field contact(pressure.size()), displacement(pressure.size());
  for (std::size_t i = 0; i < pressure.size(); ++i)
    contact[i] = in_contact(pressure[i]) ? 1.0 : 0.0;
  ComplexField scratch;
  multilevel_.displacement().apply(contact.data(), displacement.data(), scratch);
  return ordered_dot(contact.data(), displacement.data(), contact.size()) < 0;
}

Solution ContactSolver::solve_coupled(const Field& gap, const Drive& drive, Field pressure,
                                      const ContactSettings& settings) const {
  ComplexField scratch;
  const LaggedContact contact{
      [&](const Field& p, Field& separation) {
        multilevel_.displacement().apply_rest(p.data(), separation.data(), scratch);
      },
      [&](const Field& lagged, Field start, double tol) {
        return multilevel_.solve(lagged, drive, std::move(start), tol, settings.max_iterations);
      }};
  return solve_lagged(contact, grid_, gap, drive, std::move(pressure), settings.tol);
}

}  // namespace samcontact::contact
