// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/creeping_contact.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "samcontact/contact/normal/coarsening.hpp"
#include "samcontact/contact/normal/monotone_contact.hpp"

namespace samcontact::contact {
namespace {

/// Grids with a shorter side than this are solved without a coarser grid; accuracy on coarser
/// grids.
constexpr int coarsest_side = 32;
constexpr double coarse_tol = 1e-2;

}  // namespace

class CreepingContact::Level {
 public:
  Level(const Grid& grid, std::vector<operators::CreepingBody> bodies)
      : grid_(grid), bodies_(std::move(bodies)), displacement_(grid, bodies_) {}

  Solution solve(const Field& gap, const Given& normal, Field pressure, double tol,
                 int max_iterations) const {
    const double lowest = *std::min_element(gap.begin(), gap.end());
    if (auto open = separated(gap, lowest, normal)) return *std::move(open);
    double work = 0.0;
    if (is_zero(pressure)) pressure = coarse_start(gap, normal, max_iterations, work);
    Solution solution = solve_monotone(displacement_, grid_, gap, normal, std::move(pressure),
                                       rounding(gap, lowest, normal), tol, max_iterations);
    solution.work += work;
    return solution;
  }

  Field displacement(const Field& pressure) const {
    Field moved(pressure.size());
    ComplexField work;
    displacement_.apply(pressure.data(), moved.data(), work);
    return moved;
  }

 private:
  /// Zero if the grid cannot be coarsened.
  Field coarse_start(const Field& gap, const Given& normal, int max_iterations,
                     double& work) const {
    Field zero(grid_.surface_size(), 0.0);
    const bool ends = std::any_of(gap.begin(), gap.end(), [](double g) { return std::isinf(g); });
    if (ends || std::min(grid_.nx, grid_.ny) < coarsest_side || !grid_.can_be_coarsened()) {
      return zero;
    }
    {
      const std::lock_guard lock(mutex_);
      if (!coarser_) coarser_ = std::make_unique<Level>(coarsened(grid_), bodies_);
    }
    const Solution start =
        coarser_->solve(coarsened(grid_, gap), normal, Field(coarser_->grid_.surface_size(), 0.0),
                        coarse_tol, max_iterations);
    work = start.work * coarser_->displacement_.cost() / displacement_.cost();
    return refined(grid_, start.tractions.pressure);
  }

  double rounding(const Field& gap, double lowest, const Given& normal) const {
    if (!normal.is_force() || !(grid_.period.x > 0 && grid_.period.y > 0)) return 0.0;
    const double area = grid_.cell_area() * static_cast<double>(grid_.surface_size());
    return rounding_error(gap, lowest, normal.value / area * displacement_.longest_compliance());
  }

  Grid grid_;
  std::vector<operators::CreepingBody> bodies_;
  operators::CreepingDisplacement displacement_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<Level> coarser_;
};

CreepingContact::CreepingContact(const Grid& grid, std::vector<operators::CreepingBody> bodies)
    : grid_(grid), law_(hard_contact()) {
  require_deformable(std::any_of(bodies.begin(), bodies.end(),
                                 [](const auto& body) { return !body.medium->is_rigid(); }));
  finest_ = std::make_unique<Level>(grid, std::move(bodies));
}
CreepingContact::~CreepingContact() = default;
CreepingContact::CreepingContact(CreepingContact&&) noexcept = default;
CreepingContact& CreepingContact::operator=(CreepingContact&&) noexcept = default;

Field CreepingContact::displacement(const Field& pressure) const {
  require_surface(pressure, grid_, "pressure");
  return finest_->displacement(pressure);
}

Solution CreepingContact::solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                                const ContactSettings& settings) const {
  require_solvable(grid_, *law_, gap, drive, initial_pressure, settings);
  Field start = initial_pressure;
  start.resize(gap.size(), 0.0);
  for (double& p : start) p = std::max(p, 0.0);
  Solution solution =
      finest_->solve(gap, drive.normal, std::move(start), settings.tol, settings.max_iterations);
  if (!is_finite(solution) || !solution.converged) {
    throw ConvergenceError("steady contact of viscoelastic bodies did not converge at " +
                               describe(drive) + ": error " + to_short_text(solution.error) +
                               " after " + std::to_string(solution.iterations) +
                               " iterations, tol " + to_text(settings.tol) +
                               ": increase max_iterations or tol, or use smaller cells",
                           solution.iterations, solution.error);
  }
  solution.edge_warning = edge_warning(grid_, solution.tractions.pressure, describe(drive));
  if (!solution.edge_warning.empty() && settings.on_border == OnBorder::error) {
    throw too_small(grid_, solution.tractions.pressure, solution.edge_warning);
  }
  return solution;
}

}  // namespace samcontact::contact
