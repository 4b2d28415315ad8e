// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/held_forces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/tangential/projected_gradient.hpp"

namespace samcontact::contact {
namespace {

/// A force that is closer to the friction limit than this, relative to the limit, does not
/// determine the motion.
constexpr double min_margin = 1e-8;

/// Friction limits for the bounds of all cells [Pa]: tangential force in the direction in which it
/// is largest, and torque.
struct LargestForces {
  double along, torque;
};
LargestForces largest_forces(const Grid& grid, const Field& bound, const Stretch& stretch) {
  const std::vector<double> x = grid.x(), y = grid.y();
  return {grid.cell_area() * ordered_sum(bound.size(), [&](std::size_t at) { return bound[at]; }),
          grid.cell_area() * ordered_sum(bound.size(), [&](std::size_t at) {
            return bound[at] * stretch.length(-y[at % grid.ny], x[at / grid.ny]);
          })};
}

double force_of(const Given& given) { return given.is_force() ? given.value : 0.0; }

constexpr const char* beyond =
    ", the friction limit (full sliding, in which the force does not determine the motion)";

/// Throws std::invalid_argument if forces that are below the friction limits individually exceed
/// them together: for some motion their power is larger than the friction power.
void require_held_together(const Grid& grid, const TangentialDrive& drive, const Field& bound,
                           const Stretch& stretch) {
  const std::vector<double> xs = grid.x(), ys = grid.y();
  ShearProblem problem;
  for (std::size_t at = 0; at < bound.size(); ++at) {
    if (!(bound[at] > 0)) continue;
    problem.cells.push_back(at);
    problem.bound.push_back(bound[at]);
  }
  const std::size_t m = problem.size();
  if (m == 0) return;
  problem.smallest_shear =
      smallest_fraction * *std::max_element(problem.bound.begin(), problem.bound.end());
  for (int k = 0; k < 3; ++k) {
    if (!drive[k].is_force()) continue;
    Field direction(2 * m, 0.0);
    for (std::size_t c = 0; c < m; ++c) {
      const std::size_t at = problem.cells[c];
      if (k != 1) direction[c] = k == 0 ? 1.0 : -ys[at % grid.ny];
      if (k != 0) direction[m + c] = k == 1 ? 1.0 : xs[at / grid.ny];
    }
    problem.modes.push_back({std::move(direction), drive[k].value / grid.cell_area(), k});
  }
  Field shear(2 * m, 0.0), slip(2 * m, 0.0);
  std::vector<double> motion(problem.modes.size(), 0.0);
  stretch_to_circle(problem, stretch);
  if (project(problem, shear, motion)) return;
  double power = 0.0, heat = 0.0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    add_motion(problem, k, motion[k], slip);
    power += motion[k] * problem.modes[k].target;
  }
  for (std::size_t c = 0; c < m; ++c) heat += problem.bound[c] * length_of(slip[c], slip[m + c]);
  if (!(power > heat)) return;
  throw std::invalid_argument(
      "tangential_load and torque must be below the friction limit together, got " +
      to_text(force_of(drive[0])) + " N, " + to_text(force_of(drive[1])) + " N and " +
      to_text(drive[2].value) + " N m, of which friction carries at most " +
      to_text(std::floor(1e3 * heat / power) / 10) +
      " %: reduce them, or prescribe the motion instead");
}

/// Part of the largest force of friction that it can have in the direction of the prescribed force.
double part_along(const TangentialDrive& drive, const Stretch& stretch) {
  const double x = force_of(drive[0]), y = force_of(drive[1]), length = std::hypot(x, y);
  if (!stretch.is_on() || length == 0) return 1.0;
  if (drive[0].is_force() && drive[1].is_force()) return length / stretch.inverse().length(x, y);
  // The other component follows from a motion.
  return stretch.length(x / length, y / length);
}

void require_shorter(const TangentialDrive& drive, const Stretch& stretch, double largest,
                     const MotionNames& motions) {
  const double force = std::hypot(force_of(drive[0]), force_of(drive[1]));
  const double limit = largest * part_along(drive, stretch);
  require(force == 0 || force < limit * (1 - min_margin), "tangential_load",
          "less than " + to_short_text(limit, 6) + " N" + beyond, force,
          std::string("prescribe ") + motions.along + " instead");
}

/// Throws std::invalid_argument for a motion of surfaces that stick everywhere if both directions
/// are periodic: their mean shear causes no mean displacement, so no shear attains the motion.
void require_attainable(const Grid& grid, const TangentialDrive& drive, const Field& pressure,
                        const MotionNames& motions) {
  if (grid.period.x != grid.nx || grid.period.y != grid.ny) return;  // a part ends in a free edge
  if (!std::all_of(pressure.begin(), pressure.end(), in_contact)) return;
  for (const Given& given : {drive[0], drive[1]}) {
    require(given.is_force() || given.value == 0, motions.along,
            "0 in full contact without slip on a doubly periodic grid, where a uniform shear does "
            "not move the bodies",
            given.value, "prescribe tangential_load instead");
  }
}

}  // namespace

void require_held(const TangentialDrive& drive, const FrictionLaw& friction, double load,
                  const MotionNames& motions) {
  const double ratio = friction.ratio(0.0);
  if (!std::isinf(ratio)) require_shorter(drive, friction.stretch(), ratio * load, motions);
}

void require_held(const Grid& grid, const TangentialDrive& drive, const Field& pressure,
                  const FrictionLaw& friction, const Field& factor, const MotionNames& motions) {
  if (friction.prevents_slip()) return require_attainable(grid, drive, pressure, motions);
  Field bound = friction.bound(pressure);
  for (std::size_t at = 0; at < factor.size(); ++at) bound[at] *= factor[at];
  const LargestForces limits = largest_forces(grid, bound, friction.stretch());
  require_shorter(drive, friction.stretch(), limits.along, motions);
  const double torque = force_of(drive[2]);
  require(torque == 0 || std::fabs(torque) < limits.torque * (1 - min_margin), "torque",
          "less in magnitude than " + to_short_text(limits.torque, 6) + " N m" + beyond, torque,
          std::string("prescribe ") + motions.rotation + " instead");
  const bool pulled = force_of(drive[0]) != 0 || force_of(drive[1]) != 0;
  if (torque != 0 && pulled) require_held_together(grid, drive, bound, friction.stretch());
}

}  // namespace samcontact::contact
