// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/lagged_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/rigid_modes.hpp"

namespace samcontact::contact {
namespace {

constexpr int max_iterations = 200;
// With dissimilar materials, shear that rotates by 90 degrees from iteration to iteration grows
// beyond mu beta = 1, although a solution exists for any mu: from this contraction factor on, the
// iterations are accelerated.
constexpr double slow_contraction = 0.5;
constexpr int depth = 12;

/// Largest change between two fields on the cells in contact; under load control a uniform change
/// is only a change of approach, and with moments a plane one a change of tilt.
double change_in_contact(const Field& a, const Field& b, const Field& pressure,
                         const RigidModes& modes) {
  double lowest = INFINITY, highest = -INFINITY;
  Field change(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) change[i] = a[i] - b[i];
  modes.level(pressure, change);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!in_contact(pressure[i])) continue;
    lowest = std::min(lowest, change[i]);
    highest = std::max(highest, change[i]);
  }
  if (!(lowest <= highest)) return 0.0;
  return modes.normal().is_force() ? highest - lowest
                                   : std::max(std::fabs(lowest), std::fabs(highest));
}

/// Replaces the separation computed from `estimate` by the next estimate.
void accelerate(Anderson& anderson, Field& estimate, Field& separation) {
  for (std::size_t i = 0; i < estimate.size(); ++i) separation[i] -= estimate[i];
  anderson.next(estimate, std::move(separation));
  separation = estimate;
}

}  // namespace

Solution solve_lagged(const LaggedContact& contact, const Grid& grid, const Field& gap,
                      const Drive& drive, Field pressure, double tol) {
  const RigidModes modes(drive, grid);
  Field separation(gap.size()), previous(gap.size()), lagged(gap.size());
  int iterations = 0, applications = 0;
  double work = 0.0;
  const auto update = [&](const Field& p) {
    contact.separate(p, separation);
    ++applications;
    ++work;
  };
  update(pressure);

  Solution solution;
  Anderson anderson(depth);
  double outer_error = 1.0;
  bool slow = false;
  for (int n = 0; n < max_iterations; ++n) {
    for (std::size_t i = 0; i < gap.size(); ++i) lagged[i] = gap[i] + separation[i];
    const double inner_tol = std::clamp(0.1 * outer_error, 0.3 * tol, 1e-2);
    solution = contact.solve(lagged, std::move(pressure), std::max(inner_tol, 1e-13));
    iterations += solution.iterations;
    applications += solution.operator_applications;
    work += solution.work;
    if (!solution.converged) break;
    std::swap(previous, separation);
    update(solution.tractions.pressure);
    // Gap with the updated separation; its scale is the elastic displacement in the contact.
    double scale = 0.0;
    const Lowering lowering(grid, solution.motion);
    for (std::size_t i = 0; i < gap.size(); ++i) {
      scale = std::max(scale, std::fabs(solution.gap[i] + lowering(i) - lagged[i]));
    }
    const Field& pressed = solution.tractions.pressure;
    const double change = change_in_contact(separation, previous, pressed, modes);
    // The surfaces may be separated by shear that no longer exists.
    const bool parted =
        std::none_of(pressed.begin(), pressed.end(), in_contact) && !is_zero(previous);
    const double error = parted ? 1.0 : scale > 0 ? change / scale : 0.0;
    slow = slow || (n > 0 && error > slow_contraction * outer_error);
    outer_error = error;
    solution.error += outer_error;
    for (std::size_t i = 0; i < gap.size(); ++i) solution.gap[i] += separation[i] - previous[i];
    if (drive.normal.is_force()) {
      // The part of the change that is plane over the contact is a rigid-body motion.
      const RigidMotion moved = modes.close(solution.tractions.pressure, solution.gap);
      solution.motion.approach += moved.approach;
      for (int k = 0; k < 2; ++k) solution.motion.tilt[k] += moved.tilt[k];
    }
    solution.converged = solution.error <= tol;
    if (solution.converged) break;
    pressure = solution.tractions.pressure;
    if (slow) accelerate(anderson, previous, separation);
  }
  solution.iterations = iterations;
  solution.operator_applications = applications;
  solution.work = work;
  return solution;
}

}  // namespace samcontact::contact
