// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/adhesive_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/contact/normal/gap_descent.hpp"
#include "samcontact/contact/normal/tilt_search.hpp"

namespace samcontact::contact {
namespace {

/// Growth of the steps of the approach while a load is not yet enclosed, and their reduction after
/// a step beyond the largest tension.
constexpr double growth = 3.0, reduction = 0.25;
/// Steps of the search for a load, and the smallest step towards the largest tension, relative to
/// the first one.
constexpr int max_steps = 200;
constexpr double smallest_step = 1e-3;
/// Iterations of a descent under a load, beyond which its approach is searched.
constexpr int most_under_load = 200;
/// First and largest change of a tilt in the search for moments: displacement at the edge of the
/// contact, relative to the range of the attraction.
constexpr double first_tilt = 0.01, largest_tilt = 3.0;
/// Jumps of the load from branch to branch that a search follows.
constexpr int max_jumps = 5;

/// Search for the approach of a given load, along the branch of the first state.
class LoadSearch {
 public:
  LoadSearch(GapDescent& descent, double load, double tol, int max_iterations)
      : descent_(descent), load_(load), tol_(tol), max_iterations_(max_iterations) {}

  /// first: approach of the first state. step: first step [m]. scale: load of which the tolerance
  /// is a fraction [N]. presses: whether the surfaces are pressed to the load 0 before a tension,
  /// on the branch that is stable under load.
  bool run(double first, double step, double scale, bool presses) {
    scale_ = scale;
    first_step_ = step;
    if (!descend(first)) return false;
    if (presses && load_ < 0 && descent_.load() < 0) {
      const double tension = std::exchange(load_, 0.0);
      if (!press_on(step)) return false;
      load_ = tension;
    }
    if (is_reached()) return true;
    return excess() < 0 ? press_on(step) : pull_off(step);
  }

 private:
  struct Point {
    double approach, excess;
  };
  /// A solution to which the search can return.
  struct Place {
    Field gap;
    double approach;
  };

  Place here() const { return {descent_.gap().values(), descent_.gap().approach()}; }
  void return_to(const Place& place) { descent_.gap().return_to(place.gap, place.approach); }

  bool descend(double approach) { return descent_.descend(approach, tol_, max_iterations_); }
  double excess() const { return descent_.load() - load_; }
  bool is_reached() const { return std::fabs(excess()) <= load_tol() * scale_; }
  double load_tol() const { return std::max(10 * tol_, 1e-12); }

  /// Increases the approach until the load is enclosed.
  bool press_on(double step) {
    Point near{descent_.gap().approach(), excess()};
    for (int n = 0; n < max_steps; ++n, step *= growth) {
      const Place start = here();
      // Periodic surfaces touch everywhere at the largest approach.
      const double midway = 0.5 * (near.approach + descent_.gap().largest_approach());
      if (!descend(std::min(near.approach + step, midway))) return false;
      if (is_reached()) return true;
      const Point next{descent_.gap().approach(), excess()};
      if (next.excess > 0) {
        return_to(start);
        return enclose(near, next);
      }
      const double slope = (next.excess - near.excess) / (next.approach - near.approach);
      near = next;
      if (slope > 0) step = std::min(step, 1.1 * -near.excess / slope / growth);
    }
    return false;
  }

  /// Decreases the approach until the load is enclosed, or the tension decreases.
  bool pull_off(double step) {
    Point near{descent_.gap().approach(), excess()}, before = near;
    Place place = here(), place_before = place;
    Point most = near;
    double faster = growth;  // not towards the largest tension
    for (int n = 0; n < max_steps; ++n) {
      if (!descend(near.approach - step)) return false;
      if (is_reached()) return true;
      const Point next{descent_.gap().approach(), excess()};
      if (next.excess < 0) {
        return_to(place);
        return enclose(near, next);
      }
      if (next.excess >= near.excess) {
        // The largest tension, or a jump to separated surfaces, lies within this step or the last.
        step *= reduction;
        if (step < smallest_step * first_step_) throw pulled_off(most);
        faster = 1.0;
        near = before;
        place = place_before;
        return_to(place);
        continue;
      }
      const double slope = (near.excess - next.excess) / step;
      if (next.excess < most.excess) most = next;
      before = std::exchange(near, next);
      place_before = std::exchange(place, here());
      step = std::min(faster * step, 1.1 * near.excess / slope);
    }
    return false;
  }

  /// Narrows the interval of the load by the Illinois method, always from the state on the near
  /// side.
  bool enclose(Point near, Point far) {
    Place place = here();
    double near_weight = near.excess, far_weight = far.excess;
    for (int n = 0; n < max_steps; ++n) {
      const double approach =
          (near.approach * far_weight - far.approach * near_weight) / (far_weight - near_weight);
      if (!descend(approach)) return false;
      if (is_reached()) return true;
      const Point next{approach, excess()};
      if ((next.excess < 0) == (near.excess < 0)) {
        near = next;
        near_weight = next.excess;
        far_weight *= 0.5;
        place = here();
      } else {
        far = next;
        far_weight = next.excess;
        near_weight *= 0.5;
        return_to(place);
      }
      if (std::fabs(far.approach - near.approach) <=
          4 * std::numeric_limits<double>::epsilon() *
              std::max(std::fabs(far.approach), std::fabs(near.approach))) {
        return cross(far);
      }
    }
    return false;
  }

  /// Continues on the branch beyond a jump of the load.
  bool cross(const Point& far) {
    if (++jumps_ > max_jumps || !descend(far.approach)) return false;
    return is_reached() || (excess() < 0 ? press_on(first_step_) : pull_off(first_step_));
  }

  PullOffError pulled_off(const Point& last) const {
    const double largest = -(last.excess + load_);
    return {"load must be at least " + to_short_text(-largest, 6) +
                " N, the largest tension of the adhesion from this state, at an approach of " +
                to_short_text(last.approach, 6) + " m, got " + to_text(load_) +
                ": prescribe the approach to pull the surfaces apart",
            descent_.iterations(), largest, last.approach};
  }

  GapDescent& descent_;
  double load_, tol_;
  int max_iterations_;
  double scale_ = 0.0, first_step_ = 0.0;
  int jumps_ = 0;
};

/// Writes the state of a descent into a solution. spring: compliance of the machine [m/N].
void describe(const Grid& grid, const GapDescent& descent, const Drive& drive, double spring,
              Solution& solution) {
  const Given normal = drive.normal;
  const RigidMotion held = drive.held();
  solution.tractions.pressure = descent.pressure();
  solution.gap = descent.gap().over_grid();
  solution.load = normal.is_force() ? normal.value : descent.load();
  solution.motion = {descent.approach() - spring * solution.load, held.tilt};
  solution.moment = moments(grid, solution.tractions.pressure);
  solution.error = descent.error();
  solution.iterations = descent.iterations();
  solution.operator_applications = descent.applications();
  solution.work = descent.applications();
}

}  // namespace

AdhesiveContact::AdhesiveContact(const Grid& grid, const operators::SurfaceInfluence& influence,
                                 SharedContactLaw law)
    : surface_(grid, influence), law_(std::move(law)) {}

Solution AdhesiveContact::solve(const Field& gap, const Drive& drive, const Field& initial_pressure,
                                double tol, int max_iterations) const {
  const auto held = [&](const Drive& by, const Field& from) {
    return solve_held(gap, by, from, tol, max_iterations);
  };
  if (!drive.tilts_freely()) return held(drive, initial_pressure);
  const double range = law_->largest_attraction() / law_->steepest_fall();
  return find_tilts(surface_.grid(), drive, first_tilts(gap, drive, initial_pressure),
                    initial_pressure, {first_tilt * range, largest_tilt * range}, tol, held);
}

AboutAxes AdhesiveContact::first_tilts(const Field& gap, const Drive& drive,
                                       const Field& initial_pressure) const {
  AboutAxes first = drive.held().tilt;
  if (is_zero(initial_pressure)) return first;
  Field displacement(surface_.size());
  ComplexField work;
  surface_.displace(surface_.padded(initial_pressure), displacement, work);
  Field separation = surface_.over_grid(displacement);
  for (std::size_t i = 0; i < gap.size(); ++i) separation[i] += gap[i];
  const AboutAxes fitted = tilts_of(surface_.grid(), separation, initial_pressure);
  for (int k = 0; k < 2; ++k) {
    if (drive.tilt[k].is_force()) first[k] = fitted[k];
  }
  return first;
}

Solution AdhesiveContact::solve_held(const Field& gap, const Drive& drive,
                                     const Field& initial_pressure, double tol,
                                     int max_iterations) const {
  const Grid& grid = surface_.grid();
  Field tilted = gap;
  const RigidMotion held = drive.held();
  if (held.is_tilted()) {
    const Lowering lowering(grid, held);
    for (std::size_t i = 0; i < tilted.size(); ++i) tilted[i] -= lowering(i);
  }
  if (drive.normal.is_force() && !is_zero(initial_pressure)) {
    const Solution found = solve_under_load(tilted, drive, initial_pressure, tol);
    if (found.converged) return found;
  }
  const bool yields = drive.spring > 0 && !drive.normal.is_force();
  const AdhesiveSurface surface = yields ? surface_.with_spring(drive.spring) : surface_;
  GapDescent descent(surface, *law_, tilted);
  const bool warm = !is_zero(initial_pressure);
  descent.start_from(warm ? initial_pressure : Field{});
  Solution solution;
  if (drive.normal.is_force()) {
    const double attraction = law_->largest_attraction() * grid.cell_area();
    const double scale = std::max(
        std::fabs(drive.normal.value),
        warm ? grid.cell_area() *
                   ordered_sum(initial_pressure.size(),
                               [&](std::size_t i) { return std::fabs(initial_pressure[i]); })
             : attraction);
    LoadSearch search(descent, drive.normal.value, tol, max_iterations);
    solution.converged = search.run(
        descent.gap().touching(), law_->largest_attraction() / law_->steepest_fall(), scale, !warm);
  } else {
    solution.converged = descent.descend(drive.normal.value, tol, max_iterations);
  }
  describe(grid, descent, drive, yields ? drive.spring : 0.0, solution);
  return solution;
}

Solution AdhesiveContact::solve_under_load(const Field& gap, const Drive& drive,
                                           const Field& initial_pressure, double tol) const {
  const AdhesiveSurface surface = surface_.with_free_approach();
  GapDescent descent(surface, *law_, gap);
  descent.start_from(initial_pressure);
  Solution solution;
  solution.converged = descent.descend(drive.normal.value, tol, most_under_load);
  if (solution.converged) describe(surface.grid(), descent, drive, 0.0, solution);
  return solution;
}

}  // namespace samcontact::contact
